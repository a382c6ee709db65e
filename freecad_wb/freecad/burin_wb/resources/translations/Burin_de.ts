<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
  <context>
    <name>Burin</name>
    <message>
      <source>({0} more)</source>
      <translation>({0} weitere)</translation>
    </message>
    <message>
      <source>+x, -z ..., or x, y, z of a direction of the model</source>
      <translation>+x, -z ... oder x, y, z einer Richtung des Modells</translation>
    </message>
    <message>
      <source>3-D view</source>
      <translation>3D-Ansicht</translation>
    </message>
    <message>
      <source>A built-in style, or a style file</source>
      <translation>Ein eingebauter Stil oder eine Stildatei</translation>
    </message>
    <message>
      <source>A frame around the words</source>
      <translation>Ein Rahmen um die Wörter</translation>
    </message>
    <message>
      <source>A letter of its own; empty: the next one</source>
      <translation>Ein eigener Buchstabe; leer: der nächste</translation>
    </message>
    <message>
      <source>A list of the items above the lower right corner</source>
      <translation>Eine Stückliste über der rechten unteren Ecke</translation>
    </message>
    <message>
      <source>A number with a leader at each item</source>
      <translation>Eine Nummer mit Hinweislinie an jeder Position</translation>
    </message>
    <message>
      <source>A row lights up its objects in the 3-D view; objects that are selected there mark their rows</source>
      <translation>Eine Zeile hebt ihre Objekte in der 3D-Ansicht hervor; Objekte, die dort ausgewählt sind, markieren ihre Zeilen</translation>
    </message>
    <message>
      <source>A step of the objects that are selected</source>
      <translation>Ein Schritt aus den ausgewählten Objekten</translation>
    </message>
    <message>
      <source>Add</source>
      <translation>Hinzufügen</translation>
    </message>
    <message>
      <source>Add note</source>
      <translation>Hinweis hinzufügen</translation>
    </message>
    <message>
      <source>Add strokes…</source>
      <translation>Striche hinzufügen …</translation>
    </message>
    <message>
      <source>Angle</source>
      <translation>Winkel</translation>
    </message>
    <message>
      <source>Another detail: about the face, edge or vertex that is selected, or where an object was clicked</source>
      <translation>Eine weitere Einzelheit: um die ausgewählte Fläche, Kante oder Ecke, oder wo ein Objekt angeklickt wurde</translation>
    </message>
    <message>
      <source>Another detail: the objects that are selected</source>
      <translation>Eine weitere Einzelheit: die ausgewählten Objekte</translation>
    </message>
    <message>
      <source>Another dimension: of the faces, edges or vertices that are selected; without any: width, depth and height</source>
      <translation>Ein weiteres Maß: der ausgewählten Flächen, Kanten oder Eckpunkte; ohne solche: Breite, Tiefe und Höhe</translation>
    </message>
    <message>
      <source>Another note: with a leader to each of the faces, edges, vertices or objects that are selected</source>
      <translation>Ein weiterer Hinweis: mit einer Hinweislinie zu jeder ausgewählten Fläche, Kante, Ecke und jedem Objekt</translation>
    </message>
    <message>
      <source>Another number; an item that has it gets this one</source>
      <translation>Eine andere Nummer; eine Position, die sie hat, bekommt diese</translation>
    </message>
    <message>
      <source>Another plane: across the view, through the middle</source>
      <translation>Noch eine Ebene: quer zur Ansicht, durch die Mitte</translation>
    </message>
    <message>
      <source>Another plane: through the selected flat face or datum plane; what lies before it goes</source>
      <translation>Noch eine Ebene: durch die ausgewählte ebene Fläche oder Bezugsebene; was davor liegt, fällt weg</translation>
    </message>
    <message>
      <source>At</source>
      <translation>Bei</translation>
    </message>
    <message>
      <source>Axes of round faces, and marks where they are seen along their axis</source>
      <translation>Achsen runder Flächen, und Mittelkreuze, wo sie in Richtung der Achse zu sehen sind</translation>
    </message>
    <message>
      <source>Back</source>
      <translation>Hinten</translation>
    </message>
    <message>
      <source>Before the model</source>
      <translation>Vor dem Modell</translation>
    </message>
    <message>
      <source>Behind the number: H7, 0.1 (±0.1), +0.1/-0.2</source>
      <translation>Hinter der Zahl: H7, 0.1 (±0.1), +0.1/-0.2</translation>
    </message>
    <message>
      <source>Bottom</source>
      <translation>Unten</translation>
    </message>
    <message>
      <source>Cancel</source>
      <translation>Abbrechen</translation>
    </message>
    <message>
      <source>Centre lines</source>
      <translation>Mittellinien</translation>
    </message>
    <message>
      <source>Chooses a style file</source>
      <translation>Wählt eine Stildatei</translation>
    </message>
    <message>
      <source>Click a line of the illustration; Esc ends</source>
      <translation>Eine Linie der Illustration anklicken; Esc beendet</translation>
    </message>
    <message>
      <source>Clockwise</source>
      <translation>Im Uhrzeigersinn</translation>
    </message>
    <message>
      <source>Color</source>
      <translation>Farbe</translation>
    </message>
    <message>
      <source>Cut</source>
      <translation>Schneiden</translation>
    </message>
    <message>
      <source>Cuts the objects that are chosen above, or all, again</source>
      <translation>Schneidet die oben gewählten Objekte oder alle wieder</translation>
    </message>
    <message>
      <source>Decimals</source>
      <translation>Nachkommastellen</translation>
    </message>
    <message>
      <source>Delete</source>
      <translation>Löschen</translation>
    </message>
    <message>
      <source>Deletes the details that are selected above</source>
      <translation>Löscht die oben ausgewählten Einzelheiten</translation>
    </message>
    <message>
      <source>Deletes the rows that are selected above</source>
      <translation>Löscht die Zeilen, die oben ausgewählt sind</translation>
    </message>
    <message>
      <source>Deletes the steps that are selected</source>
      <translation>Löscht die ausgewählten Schritte</translation>
    </message>
    <message>
      <source>Depth</source>
      <translation>Tiefe</translation>
    </message>
    <message>
      <source>Detail</source>
      <translation>Einzelheit</translation>
    </message>
    <message>
      <source>Diameter</source>
      <translation>Durchmesser</translation>
    </message>
    <message>
      <source>Dimensions and notes</source>
      <translation>Maße und Hinweise</translation>
    </message>
    <message>
      <source>Dimetric</source>
      <translation>Dimetrisch</translation>
    </message>
    <message>
      <source>Distance</source>
      <translation>Abstand</translation>
    </message>
    <message>
      <source>Draws strokes of another kind over those that there are</source>
      <translation>Zeichnet Striche einer anderen Art über die vorhandenen</translation>
    </message>
    <message>
      <source>Draws the assembly taken apart; the model stays as it is</source>
      <translation>Zeichnet die Baugruppe zerlegt; das Modell bleibt, wie es ist</translation>
    </message>
    <message>
      <source>Draws the illustration as the 3-D view shows the model now, in perspective too</source>
      <translation>Zeichnet die Illustration so, wie die 3D-Ansicht das Modell jetzt zeigt, auch in Perspektive</translation>
    </message>
    <message>
      <source>Draws the section as a view A-A of the sheet, and leaves the other views whole; a view that sees the plane from its edge has the line of the cut</source>
      <translation>Zeichnet den Schnitt als Ansicht A-A des Blatts und lässt die anderen Ansichten ganz; die Schnittlinie steht in einer Ansicht, die die Ebene von der Kante sieht</translation>
    </message>
    <message>
      <source>Earlier</source>
      <translation>Früher</translation>
    </message>
    <message>
      <source>Edit illustration</source>
      <translation>Illustration bearbeiten</translation>
    </message>
    <message>
      <source>Ends the run; the drawing before is kept</source>
      <translation>Beendet den Lauf; gezeigt bleibt die vorige Zeichnung</translation>
    </message>
    <message>
      <source>Exclude</source>
      <translation>Ausnehmen</translation>
    </message>
    <message>
      <source>Explode</source>
      <translation>Zerlegen</translation>
    </message>
    <message>
      <source>Exploded</source>
      <translation>Zerlegt</translation>
    </message>
    <message>
      <source>Exploded views of the workbench Assembly</source>
      <translation>Explosionsansichten des Arbeitsbereichs Assembly</translation>
    </message>
    <message>
      <source>Export the drawing before</source>
      <translation>Bisherige Zeichnung exportieren</translation>
    </message>
    <message>
      <source>Filter</source>
      <translation>Filter</translation>
    </message>
    <message>
      <source>Find steps</source>
      <translation>Schritte finden</translation>
    </message>
    <message>
      <source>First angle</source>
      <translation>Methode 1</translation>
    </message>
    <message>
      <source>Fit</source>
      <translation>Einpassen</translation>
    </message>
    <message>
      <source>Flip</source>
      <translation>Umdrehen</translation>
    </message>
    <message>
      <source>Follow the 3-D view</source>
      <translation>Der 3-D-Ansicht folgen</translation>
    </message>
    <message>
      <source>Frame</source>
      <translation>Rahmen</translation>
    </message>
    <message>
      <source>From face</source>
      <translation>Aus Fläche</translation>
    </message>
    <message>
      <source>Front</source>
      <translation>Vorne</translation>
    </message>
    <message>
      <source>Height</source>
      <translation>Höhe</translation>
    </message>
    <message>
      <source>Height of the drawing on paper</source>
      <translation>Höhe der Zeichnung auf dem Papier</translation>
    </message>
    <message>
      <source>Hidden lines</source>
      <translation>Verdeckte Linien</translation>
    </message>
    <message>
      <source>How far parts have come on their ways: together, apart</source>
      <translation>Wie weit die Teile auf ihren Wegen sind: zusammen, auseinander</translation>
    </message>
    <message>
      <source>How far; the arrows in the 3-D view can be dragged too</source>
      <translation>Wie weit; auch die Pfeile in der 3D-Ansicht lassen sich ziehen</translation>
    </message>
    <message>
      <source>How hidden lines are drawn</source>
      <translation>Wie verdeckte Linien gezeichnet werden</translation>
    </message>
    <message>
      <source>How many objects are of this item</source>
      <translation>Wie viele Objekte zu dieser Position gehören</translation>
    </message>
    <message>
      <source>Illustration files</source>
      <translation>Illustrationsdateien</translation>
    </message>
    <message>
      <source>In the 3-D view too</source>
      <translation>Auch in der 3D-Ansicht</translation>
    </message>
    <message>
      <source>Instead of the number with its sign, such as 4x ⌀{value}</source>
      <translation>Statt der Zahl mit ihrem Zeichen, etwa 4x ⌀{value}</translation>
    </message>
    <message>
      <source>Isometric</source>
      <translation>Isometrisch</translation>
    </message>
    <message>
      <source>Its letter; empty: the next one</source>
      <translation>Sein Buchstabe; leer: der nächste</translation>
    </message>
    <message>
      <source>Its position along its axis</source>
      <translation>Wo sie auf ihrer Achse steht</translation>
    </message>
    <message>
      <source>Join</source>
      <translation>Verbinden</translation>
    </message>
    <message>
      <source>Key</source>
      <translation>Schlüssel</translation>
    </message>
    <message>
      <source>Kind</source>
      <translation>Art</translation>
    </message>
    <message>
      <source>Kind {0} needs one round face or edge that has it, in Features</source>
      <translation>Kind {0} braucht in Features eine runde Fläche oder Kante, die das hat</translation>
    </message>
    <message>
      <source>Kind {0} needs two faces, edges or vertices in Features</source>
      <translation>Kind {0} braucht zwei Flächen, Kanten oder Eckpunkte in Features</translation>
    </message>
    <message>
      <source>Later</source>
      <translation>Später</translation>
    </message>
    <message>
      <source>Left</source>
      <translation>Links</translation>
    </message>
    <message>
      <source>Legend of colours on the sheet</source>
      <translation>Farblegende auf dem Blatt</translation>
    </message>
    <message>
      <source>Letter</source>
      <translation>Zeichen</translation>
    </message>
    <message>
      <source>Looks in which order and how far the parts come out; replaces the steps below. Stop ends it</source>
      <translation>Sucht, in welcher Reihenfolge und wie weit die Teile herauskommen; ersetzt die Schritte unten. Anhalten beendet es</translation>
    </message>
    <message>
      <source>Makes one step of the rows that are selected</source>
      <translation>Macht aus den ausgewählten Zeilen einen Schritt</translation>
    </message>
    <message>
      <source>Millimetres of paper for a millimetre of the model</source>
      <translation>Millimeter Papier für einen Millimeter des Modells</translation>
    </message>
    <message>
      <source>Moves the plane through the model</source>
      <translation>Bewegt die Ebene durch das Modell</translation>
    </message>
    <message>
      <source>Name</source>
      <translation>Name</translation>
    </message>
    <message>
      <source>New items of a step, at the most:</source>
      <translation>Neue Positionen eines Schritts, höchstens:</translation>
    </message>
    <message>
      <source>No.</source>
      <translation>Pos.</translation>
    </message>
    <message>
      <source>Not drawn: as if the object were not there</source>
      <translation>Nicht gezeichnet: als wäre das Objekt nicht da</translation>
    </message>
    <message>
      <source>Not hatched: lines alone</source>
      <translation>Nicht schraffiert: nur Linien</translation>
    </message>
    <message>
      <source>Note</source>
      <translation>Hinweis</translation>
    </message>
    <message>
      <source>Number parts</source>
      <translation>Teile nummerieren</translation>
    </message>
    <message>
      <source>Numbers from 1 around the drawing, from the top on</source>
      <translation>Nummern ab 1 um die Zeichnung herum, von oben an</translation>
    </message>
    <message>
      <source>Numbers from 1 in the order of the assembly, without holes</source>
      <translation>Nummern ab 1 in der Reihenfolge der Baugruppe, ohne Lücken</translation>
    </message>
    <message>
      <source>Numbers in the drawing</source>
      <translation>Nummern in der Zeichnung</translation>
    </message>
    <message>
      <source>Object</source>
      <translation>Objekt</translation>
    </message>
    <message>
      <source>Object of the model; a row lights it up in the 3-D view, and is marked where it is selected there</source>
      <translation>Objekt des Modells; eine Zeile hebt es in der 3D-Ansicht hervor und wird markiert, wo es dort ausgewählt ist</translation>
    </message>
    <message>
      <source>Objects</source>
      <translation>Objekte</translation>
    </message>
    <message>
      <source>Objects that this plane does not cut, such as bolts and shafts</source>
      <translation>Objekte, die diese Ebene nicht schneidet, wie Schrauben und Wellen</translation>
    </message>
    <message>
      <source>Of the circle, in mm of the model; empty: all of the objects</source>
      <translation>Des Kreises, in mm des Modells; leer: die Objekte ganz</translation>
    </message>
    <message>
      <source>One view</source>
      <translation>Eine Ansicht</translation>
    </message>
    <message>
      <source>Open…</source>
      <translation>Öffnen</translation>
    </message>
    <message>
      <source>Overall dimensions</source>
      <translation>Hauptmaße</translation>
    </message>
    <message>
      <source>Own style</source>
      <translation>Eigener Stil</translation>
    </message>
    <message>
      <source>Paper to model, such as 5:1; empty: as large as fits on the sheet</source>
      <translation>Papier zu Modell, etwa 5:1; leer: so groß, wie das Blatt Platz hat</translation>
    </message>
    <message>
      <source>Parallel</source>
      <translation>Parallel</translation>
    </message>
    <message>
      <source>Parallel, or with vanishing points</source>
      <translation>Parallel oder mit Fluchtpunkten</translation>
    </message>
    <message>
      <source>Parts</source>
      <translation>Teile</translation>
    </message>
    <message>
      <source>Parts list of {0}</source>
      <translation>Stückliste von {0}</translation>
    </message>
    <message>
      <source>Parts list on the sheet</source>
      <translation>Stückliste auf dem Blatt</translation>
    </message>
    <message>
      <source>Perspective</source>
      <translation>Perspektive</translation>
    </message>
    <message>
      <source>Place</source>
      <translation>Ort</translation>
    </message>
    <message>
      <source>Places after the point; -1: those of the style</source>
      <translation>Stellen nach dem Komma; -1: die des Stils</translation>
    </message>
    <message>
      <source>Plane</source>
      <translation>Ebene</translation>
    </message>
    <message>
      <source>Point</source>
      <translation>Punkt</translation>
    </message>
    <message>
      <source>Quantity</source>
      <translation>Menge</translation>
    </message>
    <message>
      <source>Radius</source>
      <translation>Radius</translation>
    </message>
    <message>
      <source>Redraw first</source>
      <translation>Erst neu zeichnen</translation>
    </message>
    <message>
      <source>Renumber</source>
      <translation>Neu nummerieren</translation>
    </message>
    <message>
      <source>Reset</source>
      <translation>Zurück</translation>
    </message>
    <message>
      <source>Right</source>
      <translation>Rechts</translation>
    </message>
    <message>
      <source>Save as…</source>
      <translation>Sichern</translation>
    </message>
    <message>
      <source>Save style</source>
      <translation>Stil speichern</translation>
    </message>
    <message>
      <source>Saves the style with all changes as a file</source>
      <translation>Speichert den Stil mit allen Änderungen als Datei</translation>
    </message>
    <message>
      <source>Scale</source>
      <translation>Maßstab</translation>
    </message>
    <message>
      <source>Scale so that the drawing fills the sheet</source>
      <translation>Maßstab so, dass die Zeichnung das Blatt füllt</translation>
    </message>
    <message>
      <source>Section</source>
      <translation>Schnitt</translation>
    </message>
    <message>
      <source>Seed</source>
      <translation>Startzahl</translation>
    </message>
    <message>
      <source>Seed of all that is left to chance: another one gives other strokes</source>
      <translation>Startzahl für alles Zufällige: eine andere gibt andere Striche</translation>
    </message>
    <message>
      <source>Selected row</source>
      <translation>Gewählte Zeile</translation>
    </message>
    <message>
      <source>Several views on the sheet at one scale, front, top ... about the front view, others in the corner; none: the view above</source>
      <translation>Mehrere Ansichten auf dem Blatt in einem Maßstab, vorn, oben ... um die Vorderansicht, andere in der Ecke; keine: die Ansicht oben</translation>
    </message>
    <message>
      <source>Sheet</source>
      <translation>Blatt</translation>
    </message>
    <message>
      <source>Shows keys whose name or meaning holds these words</source>
      <translation>Zeigt Schlüssel, deren Name oder Bedeutung diese Wörter enthält</translation>
    </message>
    <message>
      <source>Shows the objects on their ways, with an arrow to drag for each step, as long as this panel is open</source>
      <translation>Zeigt die Objekte auf ihren Wegen, mit einem Pfeil zum Ziehen für jeden Schritt, solange dieses Fenster offen ist</translation>
    </message>
    <message>
      <source>Source</source>
      <translation>Quelle</translation>
    </message>
    <message>
      <source>Spreadsheet</source>
      <translation>Tabelle</translation>
    </message>
    <message>
      <source>Standard views</source>
      <translation>Standardansichten</translation>
    </message>
    <message>
      <source>Stays whole</source>
      <translation>Bleibt ganz</translation>
    </message>
    <message>
      <source>Stop</source>
      <translation>Anhalten</translation>
    </message>
    <message>
      <source>Style</source>
      <translation>Stil</translation>
    </message>
    <message>
      <source>Style file</source>
      <translation>Stildatei</translation>
    </message>
    <message>
      <source>Style files</source>
      <translation>Stildateien</translation>
    </message>
    <message>
      <source>Style of the object that is chosen above</source>
      <translation>Stil des oben gewählten Objekts</translation>
    </message>
    <message>
      <source>Symbol</source>
      <translation>Symbol</translation>
    </message>
    <message>
      <source>Take back</source>
      <translation>Zurücknehmen</translation>
    </message>
    <message>
      <source>Take over</source>
      <translation>Übernehmen</translation>
    </message>
    <message>
      <source>Takes back all changes: the values of the style itself</source>
      <translation>Nimmt alle Änderungen zurück: die Werte des Stils selbst</translation>
    </message>
    <message>
      <source>Takes back the strokes that were added last, with all changes of them</source>
      <translation>Nimmt die zuletzt hinzugefügten Striche mit all ihren Änderungen zurück</translation>
    </message>
    <message>
      <source>Takes the moves of the exploded view as steps</source>
      <translation>Nimmt die Bewegungen der Explosionsansicht als Schritte</translation>
    </message>
    <message>
      <source>Takes the other side away</source>
      <translation>Nimmt die andere Seite weg</translation>
    </message>
    <message>
      <source>Takes the plane away that is chosen above</source>
      <translation>Nimmt die oben gewählte Ebene weg</translation>
    </message>
    <message>
      <source>Text</source>
      <translation>Text</translation>
    </message>
    <message>
      <source>The axis of the model that is normal to the plane</source>
      <translation>Die Achse des Modells, zu der die Ebene quer steht</translation>
    </message>
    <message>
      <source>The colours of parts with their names</source>
      <translation>Die Farben der Teile mit ihren Namen</translation>
    </message>
    <message>
      <source>The drawing as it is now; a click shows it large</source>
      <translation>Die Zeichnung, wie sie jetzt ist; ein Klick zeigt sie groß</translation>
    </message>
    <message>
      <source>The drawing kernel is not installed.</source>
      <translation>Der Zeichenkern ist nicht installiert.</translation>
    </message>
    <message>
      <source>The objects that are selected in the 3-D view stay whole</source>
      <translation>Die in der 3D-Ansicht ausgewählten Objekte bleiben ganz</translation>
    </message>
    <message>
      <source>The planes that cut, one after the other</source>
      <translation>Die Ebenen, die schneiden, eine nach der anderen</translation>
    </message>
    <message>
      <source>The symbol around the words</source>
      <translation>Das Symbol um die Wörter</translation>
    </message>
    <message>
      <source>The view of the sheet that has it, such as top or A-A; empty: the first that shows it best</source>
      <translation>Die Ansicht des Blatts, in der es steht, etwa top oder A-A; leer: die erste, die es am besten zeigt</translation>
    </message>
    <message>
      <source>The words of the note; {part.name}, {item}, {length}, {area}, {diameter}, {radius}, {volume} are values of what it points at</source>
      <translation>Die Wörter des Hinweises; {part.name}, {item}, {length}, {area}, {diameter}, {radius}, {volume} sind Werte dessen, worauf er zeigt</translation>
    </message>
    <message>
      <source>Third angle</source>
      <translation>Methode 3</translation>
    </message>
    <message>
      <source>This FreeCAD takes {0} pixels of a symbol for a millimetre; illustrations on pages were made anew for it</source>
      <translation>Dieses FreeCAD nimmt {0} Pixel eines Symbols für einen Millimeter; Illustrationen auf Seiten wurden dafür neu gemacht</translation>
    </message>
    <message>
      <source>Thread</source>
      <translation>Gewinde</translation>
    </message>
    <message>
      <source>Tolerance</source>
      <translation>Toleranz</translation>
    </message>
    <message>
      <source>Top</source>
      <translation>Oben</translation>
    </message>
    <message>
      <source>Transparent: what lies behind is drawn too</source>
      <translation>Durchsichtig: was dahinter liegt, wird auch gezeichnet</translation>
    </message>
    <message>
      <source>Trimetric</source>
      <translation>Trimetrisch</translation>
    </message>
    <message>
      <source>Value</source>
      <translation>Wert</translation>
    </message>
    <message>
      <source>Variant</source>
      <translation>Variante</translation>
    </message>
    <message>
      <source>Vertical field of view, {0:g} to {1:g} degrees</source>
      <translation>Senkrechter Bildwinkel, {0:g} bis {1:g} Grad</translation>
    </message>
    <message>
      <source>View</source>
      <translation>Ansicht</translation>
    </message>
    <message>
      <source>View of its own</source>
      <translation>Eigene Ansicht</translation>
    </message>
    <message>
      <source>Way</source>
      <translation>Weg</translation>
    </message>
    <message>
      <source>Ways that are tried where steps are found</source>
      <translation>Wege, die versucht werden, wo Schritte gesucht werden</translation>
    </message>
    <message>
      <source>What is drawn again; a row lights up its objects in the 3-D view</source>
      <translation>Was noch einmal gezeichnet wird; eine Zeile hebt ihre Objekte in der 3D-Ansicht hervor</translation>
    </message>
    <message>
      <source>What is measured or noted; a row lights it up in the 3-D view</source>
      <translation>Was gemessen wird oder worauf ein Hinweis zeigt; eine Zeile hebt es in der 3D-Ansicht hervor</translation>
    </message>
    <message>
      <source>What is measured, or a note</source>
      <translation>Was gemessen wird, oder ein Hinweis</translation>
    </message>
    <message>
      <source>What moves together; a row lights up its objects in the 3-D view</source>
      <translation>Was sich gemeinsam bewegt; eine Zeile hebt ihre Objekte in der 3D-Ansicht hervor</translation>
    </message>
    <message>
      <source>Where the view from the left goes: to the right of the front view (first angle), or to its left (third angle)</source>
      <translation>Wo die Ansicht von links steht: rechts von der Vorderansicht (Projektionsmethode 1) oder links davon (Projektionsmethode 3)</translation>
    </message>
    <message>
      <source>Whether a line shows the way</source>
      <translation>Ob eine Linie den Weg zeigt</translation>
    </message>
    <message>
      <source>Which of these symbols</source>
      <translation>Welches dieser Symbole</translation>
    </message>
    <message>
      <source>Width</source>
      <translation>Breite</translation>
    </message>
    <message>
      <source>Width of the drawing on paper</source>
      <translation>Breite der Zeichnung auf dem Papier</translation>
    </message>
    <message>
      <source>Writes the list into a spreadsheet of the document, and puts that on the pages that show the illustration</source>
      <translation>Schreibt die Liste in eine Tabelle des Dokuments und legt diese auf die Seiten, die die Illustration zeigen</translation>
    </message>
    <message>
      <source>a dimension has one or two faces, edges or vertices; {0} are selected</source>
      <translation>ein Maß hat eine oder zwei Flächen, Kanten oder Eckpunkte; ausgewählt sind {0}</translation>
    </message>
    <message>
      <source>a flat face alone has no dimension; select another face, edge or vertex too</source>
      <translation>eine ebene Fläche allein hat kein Maß; wählen Sie noch eine Fläche, eine Kante oder einen Eckpunkt dazu</translation>
    </message>
    <message>
      <source>a radius is more than 0 mm</source>
      <translation>ein Radius ist größer als 0 mm</translation>
    </message>
    <message>
      <source>a scale is such as 5:1 or 1:2</source>
      <translation>ein Maßstab ist etwa 5:1 oder 1:2</translation>
    </message>
    <message>
      <source>a section lies in this plane already; move it, or add another one</source>
      <translation>in dieser Ebene liegt schon ein Schnitt; verschieben Sie ihn oder fügen Sie einen anderen hinzu</translation>
    </message>
    <message>
      <source>a step moves its parts by more than 0 mm</source>
      <translation>ein Schritt bewegt seine Teile um mehr als 0 mm</translation>
    </message>
    <message>
      <source>a thread needs Text, such as M8: its shape alone does not tell</source>
      <translation>ein Gewinde braucht Text, etwa M8: aus der Form allein geht es nicht hervor</translation>
    </message>
    <message>
      <source>a vertex alone has no dimension; select another vertex, face or edge too</source>
      <translation>ein Eckpunkt allein hat kein Maß; wählen Sie noch einen Eckpunkt, eine Fläche oder eine Kante dazu</translation>
    </message>
    <message>
      <source>a way is +x, -x, +y, -y, +z, -z or three numbers such as 1, 0, 1</source>
      <translation>ein Weg ist +x, -x, +y, -y, +z, -z oder drei Zahlen wie 1, 0, 1</translation>
    </message>
    <message>
      <source>across x</source>
      <translation>quer zu x</translation>
    </message>
    <message>
      <source>across y</source>
      <translation>quer zu y</translation>
    </message>
    <message>
      <source>across z</source>
      <translation>quer zu z</translation>
    </message>
    <message>
      <source>all feature lines, hidden ones too: haloes and widths alone show depth</source>
      <translation>alle Formlinien, auch verdeckte: nur Höfe und Strichbreiten zeigen die Tiefe</translation>
    </message>
    <message>
      <source>all ways</source>
      <translation>alle Wege</translation>
    </message>
    <message>
      <source>an item has a number from 1 to 99999</source>
      <translation>eine Position hat eine Nummer von 1 bis 99999</translation>
    </message>
    <message>
      <source>another detail has this letter</source>
      <translation>eine andere Einzelheit hat diesen Buchstaben</translation>
    </message>
    <message>
      <source>another panel is open; close it first</source>
      <translation>ein anderes Fenster ist offen; schließen Sie es zuerst</translation>
    </message>
    <message>
      <source>any</source>
      <translation>beliebig</translation>
    </message>
    <message>
      <source>as it is</source>
      <translation>wie sie ist</translation>
    </message>
    <message>
      <source>as the others</source>
      <translation>wie die anderen</translation>
    </message>
    <message>
      <source>balloon</source>
      <translation>Kreis</translation>
    </message>
    <message>
      <source>bevel</source>
      <translation>HV-Naht</translation>
    </message>
    <message>
      <source>black lines over three tints of one spot ink, for two printing plates</source>
      <translation>schwarze Linien über drei Tönen einer Schmuckfarbe, für zwei Druckplatten</translation>
    </message>
    <message>
      <source>bold: few broad strokes that swell from white to almost black</source>
      <translation>kräftig: wenige breite Striche, die von Weiß bis fast Schwarz anschwellen</translation>
    </message>
    <message>
      <source>both are at one place, so they have no distance</source>
      <translation>beide liegen an derselben Stelle und haben keinen Abstand</translation>
    </message>
    <message>
      <source>break</source>
      <translation>Bruchlinien</translation>
    </message>
    <message>
      <source>build</source>
      <translation>Aufbau</translation>
    </message>
    <message>
      <source>callout</source>
      <translation>Positionsnummern</translation>
    </message>
    <message>
      <source>cancelled</source>
      <translation>abgebrochen</translation>
    </message>
    <message>
      <source>check</source>
      <translation>Prüfung</translation>
    </message>
    <message>
      <source>compose</source>
      <translation>Zusammensetzen</translation>
    </message>
    <message>
      <source>cover</source>
      <translation>Überdeckung</translation>
    </message>
    <message>
      <source>curvature</source>
      <translation>Krümmung</translation>
    </message>
    <message>
      <source>dashed</source>
      <translation>gestrichelt</translation>
    </message>
    <message>
      <source>depth</source>
      <translation>Tiefe</translation>
    </message>
    <message>
      <source>dimension</source>
      <translation>Bemaßung</translation>
    </message>
    <message>
      <source>drawing</source>
      <translation>wird gezeichnet</translation>
    </message>
    <message>
      <source>drawn</source>
      <translation>gezeichnet</translation>
    </message>
    <message>
      <source>electricity</source>
      <translation>Elektrizität</translation>
    </message>
    <message>
      <source>feature</source>
      <translation>Merkmale</translation>
    </message>
    <message>
      <source>feature lines alone: thick outer outline, thin inner lines (ISO 128)</source>
      <translation>nur Formlinien: dicker Umriss außen, dünne Linien innen (ISO 128)</translation>
    </message>
    <message>
      <source>feature lines, and light hatching where the part lies in shade</source>
      <translation>Formlinien, und leichte Schraffur, wo das Teil im Schatten liegt</translation>
    </message>
    <message>
      <source>features</source>
      <translation>Merkmallinien</translation>
    </message>
    <message>
      <source>field</source>
      <translation>Richtungsfeld</translation>
    </message>
    <message>
      <source>fill</source>
      <translation>Füllung</translation>
    </message>
    <message>
      <source>fillet</source>
      <translation>Kehlnaht</translation>
    </message>
    <message>
      <source>full tone by dots, small where it is light, dense where it is dark</source>
      <translation>voller Ton aus Punkten, klein im Licht, dicht im Schatten</translation>
    </message>
    <message>
      <source>full tone: many short, thin strokes along the form, as a hand lays them</source>
      <translation>voller Ton: viele kurze, dünne Striche entlang der Form, wie von Hand gesetzt</translation>
    </message>
    <message>
      <source>full tone: swelling strokes along the form, crossed where it is dark</source>
      <translation>voller Ton: schwellende Striche entlang der Form, gekreuzt, wo es dunkel ist</translation>
    </message>
    <message>
      <source>general</source>
      <translation>allgemein</translation>
    </message>
    <message>
      <source>glass</source>
      <translation>Glas</translation>
    </message>
    <message>
      <source>halo</source>
      <translation>Lichtsaum</translation>
    </message>
    <message>
      <source>hatch</source>
      <translation>Schraffur</translation>
    </message>
    <message>
      <source>help_en</source>
      <translation>help_de</translation>
    </message>
    <message>
      <source>hot</source>
      <translation>heiß</translation>
    </message>
    <message>
      <source>it has no words; write some in Text, or choose a Symbol</source>
      <translation>ohne Wörter; schreiben Sie welche in Text oder wählen Sie ein Symbol</translation>
    </message>
    <message>
      <source>it is neither flat nor straight nor round, so nothing of it can be measured</source>
      <translation>es ist weder eben noch gerade noch rund; daran lässt sich nichts messen</translation>
    </message>
    <message>
      <source>its features are gone; choose its Features again, or delete it</source>
      <translation>was es misst, ist nicht mehr da; wählen Sie Features neu oder löschen Sie es</translation>
    </message>
    <message>
      <source>its features have Kind {0}, not {1}; change Kind, or choose its Features again</source>
      <translation>was es misst, hat Kind {0}, nicht {1}; ändern Sie Kind oder wählen Sie Features neu</translation>
    </message>
    <message>
      <source>kept</source>
      <translation>bleibt</translation>
    </message>
    <message>
      <source>landscape</source>
      <translation>quer</translation>
    </message>
    <message>
      <source>light strokes; lines behind others keep clear of them, far lines are thin</source>
      <translation>leichte Striche; Linien hinter anderen halten Abstand von ihnen, ferne Linien sind dünn</translation>
    </message>
    <message>
      <source>line</source>
      <translation>Linien</translation>
    </message>
    <message>
      <source>lines of equal height over the whole form, like a map's</source>
      <translation>Linien gleicher Höhe über die ganze Form wie auf einer Landkarte</translation>
    </message>
    <message>
      <source>lines of two widths, shaded sparsely, that bear copying and scaling down</source>
      <translation>Linien in zwei Breiten, sparsam schattiert, die Kopieren und Verkleinern vertragen</translation>
    </message>
    <message>
      <source>mandatory</source>
      <translation>Gebot</translation>
    </message>
    <message>
      <source>manual</source>
      <translation>Anleitung lesen</translation>
    </message>
    <message>
      <source>mm</source>
      <translation>mm</translation>
    </message>
    <message>
      <source>no symbol</source>
      <translation>kein Symbol</translation>
    </message>
    <message>
      <source>none</source>
      <translation>keine</translation>
    </message>
    <message>
      <source>not drawn: {0}</source>
      <translation>nicht gezeichnet: {0}</translation>
    </message>
    <message>
      <source>nothing comes apart</source>
      <translation>nichts lässt sich zerlegen</translation>
    </message>
    <message>
      <source>nothing to draw: show or select the parts, bodies, meshes or assemblies to be drawn first</source>
      <translation>nichts zu zeichnen: zeigen oder wählen Sie zuerst die Teile, Körper, Netze oder Baugruppen, die gezeichnet werden sollen</translation>
    </message>
    <message>
      <source>nothing to draw: {0}</source>
      <translation>nichts zu zeichnen: {0}</translation>
    </message>
    <message>
      <source>off</source>
      <translation>aus</translation>
    </message>
    <message>
      <source>one of both is neither flat nor straight nor round, so nothing is measured between them</source>
      <translation>eines von beiden ist weder eben noch gerade noch rund; dazwischen lässt sich nichts messen</translation>
    </message>
    <message>
      <source>one pen: lines of one width as plain polylines, closer where it is dark</source>
      <translation>ein Stift: Linien einer Breite als einfache Linienzüge, dichter im Dunkeln</translation>
    </message>
    <message>
      <source>parts in their colours under the lines</source>
      <translation>Teile in ihren Farben unter den Linien</translation>
    </message>
    <message>
      <source>parts in their colours, three tones of each, and a bold outline</source>
      <translation>Teile in ihren Farben, je drei Töne, mit kräftigem Umriss</translation>
    </message>
    <message>
      <source>parts in their colours, two tones of each, under the lines</source>
      <translation>Teile in ihren Farben, je zwei Töne, unter den Linien</translation>
    </message>
    <message>
      <source>plain</source>
      <translation>schlicht</translation>
    </message>
    <message>
      <source>plug</source>
      <translation>Lochnaht</translation>
    </message>
    <message>
      <source>pmi</source>
      <translation>Fertigungsangaben</translation>
    </message>
    <message>
      <source>portrait</source>
      <translation>hoch</translation>
    </message>
    <message>
      <source>prohibition</source>
      <translation>Verbot</translation>
    </message>
    <message>
      <source>read</source>
      <translation>Lesen</translation>
    </message>
    <message>
      <source>removed</source>
      <translation>abgetragen</translation>
    </message>
    <message>
      <source>select a face too</source>
      <translation>wählen Sie auch eine Fläche</translation>
    </message>
    <message>
      <source>select a face, an edge or a vertex, or click an object in the 3-D view</source>
      <translation>wählen Sie eine Fläche, Kante oder Ecke, oder klicken Sie ein Objekt in der 3D-Ansicht an</translation>
    </message>
    <message>
      <source>select a flat face or a datum plane</source>
      <translation>eine ebene Fläche oder eine Bezugsebene auswählen</translation>
    </message>
    <message>
      <source>select an illustration</source>
      <translation>wählen Sie eine Illustration</translation>
    </message>
    <message>
      <source>select an object of the illustration (and the illustration, where there are several)</source>
      <translation>wählen Sie ein Objekt der Illustration (und die Illustration, wo es mehrere gibt)</translation>
    </message>
    <message>
      <source>select objects in the 3-D view or the tree</source>
      <translation>Objekte in der 3D-Ansicht oder im Baum auswählen</translation>
    </message>
    <message>
      <source>select objects of the illustration in the 3-D view or the tree</source>
      <translation>Objekte der Illustration in der 3D-Ansicht oder im Baum auswählen</translation>
    </message>
    <message>
      <source>select one illustration</source>
      <translation>wählen Sie eine Illustration</translation>
    </message>
    <message>
      <source>select one illustration that is drawn</source>
      <translation>wählen Sie eine Illustration, die gezeichnet ist</translation>
    </message>
    <message>
      <source>select the illustration too: this document has several</source>
      <translation>wählen Sie auch die Illustration: dieses Dokument hat mehrere</translation>
    </message>
    <message>
      <source>select two rows or more</source>
      <translation>zwei oder mehr Zeilen auswählen</translation>
    </message>
    <message>
      <source>select what the note is about: faces, edges, vertices or objects</source>
      <translation>wählen Sie aus, worum es im Hinweis geht: Flächen, Kanten, Eckpunkte oder Objekte</translation>
    </message>
    <message>
      <source>shadow</source>
      <translation>Schatten</translation>
    </message>
    <message>
      <source>sheet</source>
      <translation>Blatt</translation>
    </message>
    <message>
      <source>show a 3-D view of the model first</source>
      <translation>zeigen Sie zuerst eine 3D-Ansicht des Modells</translation>
    </message>
    <message>
      <source>spot</source>
      <translation>Punktnaht</translation>
    </message>
    <message>
      <source>square</source>
      <translation>I-Naht</translation>
    </message>
    <message>
      <source>stopping</source>
      <translation>wird angehalten</translation>
    </message>
    <message>
      <source>strokes</source>
      <translation>Striche</translation>
    </message>
    <message>
      <source>surface</source>
      <translation>Oberfläche</translation>
    </message>
    <message>
      <source>the drawing has no numbers yet</source>
      <translation>die Zeichnung hat noch keine Nummern</translation>
    </message>
    <message>
      <source>the selection has no visible shape</source>
      <translation>die Auswahl hat keine sichtbare Form</translation>
    </message>
    <message>
      <source>the template {0} is not there; choose another one in the preferences of Burin</source>
      <translation>die Vorlage {0} ist nicht da; wählen Sie eine andere in den Einstellungen von Burin</translation>
    </message>
    <message>
      <source>there is no illustration yet; make one with New illustration first</source>
      <translation>es gibt noch keine Illustration; machen Sie zuerst eine mit Neue Illustration</translation>
    </message>
    <message>
      <source>there is no line of the illustration here</source>
      <translation>hier ist keine Linie der Illustration</translation>
    </message>
    <message>
      <source>this document has several pages; select one of them too</source>
      <translation>das Dokument hat mehrere Seiten; wählen Sie auch eine davon</translation>
    </message>
    <message>
      <source>tone</source>
      <translation>Tonwert</translation>
    </message>
    <message>
      <source>trace</source>
      <translation>Striche</translation>
    </message>
    <message>
      <source>v</source>
      <translation>V-Naht</translation>
    </message>
    <message>
      <source>verify</source>
      <translation>Prüfung</translation>
    </message>
    <message>
      <source>visibility</source>
      <translation>Sichtbarkeit</translation>
    </message>
    <message>
      <source>warning</source>
      <translation>Warnung</translation>
    </message>
    <message>
      <source>weld</source>
      <translation>Schweißnaht</translation>
    </message>
    <message>
      <source>white lines on blue, light hatching where the part lies in shade</source>
      <translation>weiße Linien auf Blau, leichte Schraffur, wo das Teil im Schatten liegt</translation>
    </message>
    <message>
      <source>white on black: strokes carry the light, as a scraper lays them</source>
      <translation>weiß auf schwarz: Striche tragen das Licht, wie ein Schabmesser sie zieht</translation>
    </message>
    <message>
      <source>white parts with pale grey shade, for printed instructions</source>
      <translation>weiße Teile mit hellgrauem Schatten, für gedruckte Anleitungen</translation>
    </message>
    <message>
      <source>write</source>
      <translation>Schreiben</translation>
    </message>
    <message>
      <source>written to {0}</source>
      <translation>in {0} geschrieben</translation>
    </message>
    <message>
      <source>{0} at {1} mm</source>
      <translation>{0} bei {1} mm</translation>
    </message>
    <message>
      <source>{0} belongs to no illustration; delete it</source>
      <translation>{0} gehört zu keiner Illustration; löschen Sie es</translation>
    </message>
    <message>
      <source>{0} has its overall dimensions already; select faces or edges for others</source>
      <translation>{0} hat die Hauptmaße schon; wählen Sie Flächen oder Kanten für andere Maße</translation>
    </message>
    <message>
      <source>{0} has no drawing that can be read ({1}); recompute it</source>
      <translation>{0} hat keine lesbare Zeichnung ({1}); berechnen Sie sie neu</translation>
    </message>
    <message>
      <source>{0} has no lines that could be measured</source>
      <translation>{0} hat keine Linien, die man bemaßen könnte</translation>
    </message>
    <message>
      <source>{0} has several views; it follows the 3-D view as soon as it has one</source>
      <translation>{0} hat mehrere Ansichten; sie folgt der 3D-Ansicht, sobald sie eine hat</translation>
    </message>
    <message>
      <source>{0} illustrations drawn anew, {1} as they were</source>
      <translation>{0} Illustrationen neu gezeichnet, {1} wie zuvor</translation>
    </message>
    <message>
      <source>{0} is a mesh, which has no faces and edges that can be measured</source>
      <translation>{0} ist ein Netz; es hat keine Flächen und Kanten, die sich messen lassen</translation>
    </message>
    <message>
      <source>{0} is gone; choose its Features again, or delete it</source>
      <translation>{0} ist nicht mehr da; wählen Sie Features neu oder löschen Sie das Maß</translation>
    </message>
    <message>
      <source>{0} is no longer in the document</source>
      <translation>{0} ist nicht mehr im Dokument</translation>
    </message>
    <message>
      <source>{0} is not drawn here; add it to Sources, or choose other Features</source>
      <translation>{0} wird hier nicht gezeichnet; nehmen Sie es in Sources auf oder wählen Sie andere Features</translation>
    </message>
    <message>
      <source>{0} is not drawn yet; recompute it</source>
      <translation>{0} ist noch nicht gezeichnet; neu berechnen</translation>
    </message>
    <message>
      <source>{0} is not up to date.</source>
      <translation>{0} ist nicht auf dem neuesten Stand.</translation>
    </message>
    <message>
      <source>{0} is selected as a whole; select faces, edges or vertices in the 3-D view</source>
      <translation>{0} ist als Ganzes ausgewählt; wählen Sie Flächen, Kanten oder Eckpunkte in der 3D-Ansicht</translation>
    </message>
    <message>
      <source>{0} lines</source>
      <translation>{0} Linien</translation>
    </message>
    <message>
      <source>{0} measures this already; select other faces or edges</source>
      <translation>{0} misst das schon; wählen Sie andere Flächen oder Kanten</translation>
    </message>
    <message>
      <source>{0} views</source>
      <translation>{0} Ansichten</translation>
    </message>
  </context>
  <context>
    <name>BurinPreferences</name>
    <message>
      <source>A style file instead of the style above; empty = none</source>
      <translation>Eine Stildatei anstelle des Stils oben; leer = keine</translation>
    </message>
    <message>
      <source>Drawing kernel</source>
      <translation>Zeichenkern</translation>
    </message>
    <message>
      <source>Folder</source>
      <translation>Ordner</translation>
    </message>
    <message>
      <source>General</source>
      <translation>Allgemein</translation>
    </message>
    <message>
      <source>Hidden lines</source>
      <translation>Verdeckte Linien</translation>
    </message>
    <message>
      <source>How new illustrations draw hidden lines</source>
      <translation>Wie neue Illustrationen verdeckte Linien zeichnen</translation>
    </message>
    <message>
      <source>New illustrations</source>
      <translation>Neue Illustrationen</translation>
    </message>
    <message>
      <source>Python program</source>
      <translation>Python-Programm</translation>
    </message>
    <message>
      <source>Size on paper</source>
      <translation>Größe auf dem Papier</translation>
    </message>
    <message>
      <source>Style</source>
      <translation>Stil</translation>
    </message>
    <message>
      <source>Style file</source>
      <translation>Stildatei</translation>
    </message>
    <message>
      <source>TechDraw pages</source>
      <translation>TechDraw-Seiten</translation>
    </message>
    <message>
      <source>Template</source>
      <translation>Vorlage</translation>
    </message>
    <message>
      <source>Template of pages that Burin makes; empty = the smallest blank A4 to A0 that holds the drawing</source>
      <translation>Vorlage der Seiten, die Burin anlegt; leer = die kleinste Größe A4 bis A0 ohne Rahmen, auf die die Zeichnung passt</translation>
    </message>
    <message>
      <source>The Python that runs the kernel in a process of its own; empty = the system's</source>
      <translation>Das Python, das den Kern in einem eigenen Prozess ausführt; leer = das des Systems</translation>
    </message>
    <message>
      <source>The folder that holds the Python module burin; empty = found by itself</source>
      <translation>Der Ordner mit dem Python-Modul burin; leer = wird von selbst gefunden</translation>
    </message>
    <message>
      <source>The style that new illustrations start with</source>
      <translation>Der Stil, mit dem neue Illustrationen beginnen</translation>
    </message>
    <message>
      <source>Width and height that new illustrations start with</source>
      <translation>Breite und Höhe, mit denen neue Illustrationen beginnen</translation>
    </message>
  </context>
  <context>
    <name>Burin_CentreLines</name>
    <message>
      <source>Centre lines</source>
      <translation>Mittellinien</translation>
    </message>
    <message>
      <source>Draws the axes of round faces, and marks where these are seen along their axis; once more: leaves them out</source>
      <translation>Zeichnet die Achsen runder Flächen und Kreuze, wo man sie in Achsrichtung sieht; noch einmal: lässt sie weg</translation>
    </message>
  </context>
  <context>
    <name>Burin_Detail</name>
    <message>
      <source>Detail</source>
      <translation>Einzelheit</translation>
    </message>
    <message>
      <source>Draws a place again beside the view, larger, in a circle: of the selected objects, or about a selected face, edge or point</source>
      <translation>Zeichnet eine Stelle neben der Ansicht noch einmal, größer, in einem Kreis: die ausgewählten Objekte, oder um eine ausgewählte Fläche, Kante oder Ecke</translation>
    </message>
  </context>
  <context>
    <name>Burin_Dimension</name>
    <message>
      <source>Dimension</source>
      <translation>Maß</translation>
    </message>
    <message>
      <source>Writes a dimension of the selected faces, edges or vertices: a distance or an angle of two, the diameter or radius of a round one, the length of an edge; without any: width, depth and height</source>
      <translation>Schreibt ein Maß der ausgewählten Flächen, Kanten oder Eckpunkte: Abstand oder Winkel von zweien, Durchmesser oder Radius einer runden, Länge einer Kante; ohne Auswahl: Breite, Tiefe und Höhe</translation>
    </message>
  </context>
  <context>
    <name>Burin_Edit</name>
    <message>
      <source>Edit illustration</source>
      <translation>Illustration bearbeiten</translation>
    </message>
    <message>
      <source>Opens the panel of the selected illustration (a double-click in the tree does too)</source>
      <translation>Öffnet das Fenster der gewählten Illustration (auch durch Doppelklick im Baum)</translation>
    </message>
  </context>
  <context>
    <name>Burin_Explode</name>
    <message>
      <source>Explode</source>
      <translation>Zerlegen</translation>
    </message>
    <message>
      <source>Takes the assembly apart in the drawing by steps that are found and can be edited; the model stays as it is</source>
      <translation>Zerlegt die Baugruppe in der Zeichnung, in Schritten, die gefunden werden und bearbeitet werden können; das Modell bleibt, wie es ist</translation>
    </message>
  </context>
  <context>
    <name>Burin_Export</name>
    <message>
      <source>Export illustration...</source>
      <translation>Illustration exportieren …</translation>
    </message>
    <message>
      <source>Writes the illustration as a file: for print, for the web, for drawing programs</source>
      <translation>Schreibt die Illustration als Datei: für den Druck, für das Web, für Zeichenprogramme</translation>
    </message>
  </context>
  <context>
    <name>Burin_ExportFile</name>
    <message>
      <source>Export illustration file...</source>
      <translation>Illustrationsdatei exportieren …</translation>
    </message>
    <message>
      <source>Writes an illustration file and the models of its parts: the command burin draws them without FreeCAD</source>
      <translation>Schreibt eine Illustrationsdatei und die Modelle ihrer Teile: der Befehl burin zeichnet sie ohne FreeCAD</translation>
    </message>
  </context>
  <context>
    <name>Burin_Help</name>
    <message>
      <source>Burin help</source>
      <translation>Hilfe zu Burin</translation>
    </message>
    <message>
      <source>What the commands do, and the way from a part to a printed page</source>
      <translation>Was die Befehle tun, und der Weg vom Teil zur gedruckten Seite</translation>
    </message>
  </context>
  <context>
    <name>Burin_LinesForDimensions</name>
    <message>
      <source>Lines for dimensions</source>
      <translation>Linien zum Bemaßen</translation>
    </message>
    <message>
      <source>Puts the illustration's lines on the page as edges, over its picture where that is there: TechDraw dimensions on them measure the model</source>
      <translation>Legt die Linien der Illustration als Kanten auf die Seite, über ihr Bild, wo es dort ist: Maße von TechDraw an ihnen nennen Längen des Modells</translation>
    </message>
  </context>
  <context>
    <name>Burin_Look</name>
    <message>
      <source>How the selected objects are drawn; once more takes it back</source>
      <translation>Wie die gewählten Objekte gezeichnet werden; noch einmal nimmt es zurück</translation>
    </message>
    <message>
      <source>Look of objects</source>
      <translation>Aussehen von Objekten</translation>
    </message>
  </context>
  <context>
    <name>Burin_LookNotDrawn</name>
    <message>
      <source>Draws the illustration as if the selected objects were not there</source>
      <translation>Zeichnet die Illustration, als wären die gewählten Objekte nicht da</translation>
    </message>
    <message>
      <source>Not drawn</source>
      <translation>Nicht gezeichnet</translation>
    </message>
  </context>
  <context>
    <name>Burin_LookNotHatched</name>
    <message>
      <source>Draws the selected objects with lines alone, without strokes that carry the tone</source>
      <translation>Zeichnet die gewählten Objekte nur mit Linien, ohne Striche für den Ton</translation>
    </message>
    <message>
      <source>Not hatched</source>
      <translation>Nicht schraffiert</translation>
    </message>
  </context>
  <context>
    <name>Burin_LookTransparent</name>
    <message>
      <source>Draws the selected objects with lines alone, and what lies behind them too</source>
      <translation>Zeichnet die gewählten Objekte nur mit Linien, und auch, was dahinter liegt</translation>
    </message>
    <message>
      <source>Transparent</source>
      <translation>Durchsichtig</translation>
    </message>
  </context>
  <context>
    <name>Burin_NewFromFile</name>
    <message>
      <source>Draws the objects that an illustration file names, with its looks, view, sheet, style and light</source>
      <translation>Zeichnet die Objekte, die eine Illustrationsdatei nennt, mit deren Aussehen, Ansicht, Blatt, Stil und Licht</translation>
    </message>
    <message>
      <source>New illustration from file...</source>
      <translation>Neue Illustration aus Datei …</translation>
    </message>
  </context>
  <context>
    <name>Burin_NewIllustration</name>
    <message>
      <source>Draws the selected parts, bodies, meshes or assemblies (nothing selected: all that are shown) as the 3-D view shows them</source>
      <translation>Zeichnet die gewählten Teile, Körper, Netze oder Baugruppen (nichts gewählt: alle sichtbaren), wie die 3D-Ansicht sie zeigt</translation>
    </message>
    <message>
      <source>New illustration</source>
      <translation>Neue Illustration</translation>
    </message>
  </context>
  <context>
    <name>Burin_Note</name>
    <message>
      <source>Note</source>
      <translation>Hinweis</translation>
    </message>
    <message>
      <source>Writes words beside the drawing, with a leader to each of the selected faces, edges, vertices or objects</source>
      <translation>Schreibt Wörter neben die Zeichnung, mit einer Hinweislinie zu jeder ausgewählten Fläche, Kante, Ecke und jedem ausgewählten Objekt</translation>
    </message>
  </context>
  <context>
    <name>Burin_NumberParts</name>
    <message>
      <source>Number parts</source>
      <translation>Teile nummerieren</translation>
    </message>
    <message>
      <source>Numbers the items of an assembly with leaders in the drawing, lists them on the sheet and as a spreadsheet</source>
      <translation>Nummeriert die Positionen einer Baugruppe mit Hinweislinien in der Zeichnung, führt sie auf dem Blatt und als Tabelle auf</translation>
    </message>
  </context>
  <context>
    <name>Burin_PlaceOnPage</name>
    <message>
      <source>Place on TechDraw page</source>
      <translation>Auf TechDraw-Seite legen</translation>
    </message>
    <message>
      <source>Puts the illustration on a TechDraw page at its own scale; makes the page where there is none</source>
      <translation>Legt die Illustration in ihrem Maßstab auf eine TechDraw-Seite; legt die Seite an, wo keine ist</translation>
    </message>
  </context>
  <context>
    <name>Burin_RedrawAll</name>
    <message>
      <source>Looks at all illustrations of the document, style files and models too, and draws those that are not up to date; the status bar shows progress and can end it</source>
      <translation>Sieht alle Illustrationen des Dokuments an, auch Stildateien und Modelle, und zeichnet, was nicht auf dem neuesten Stand ist; die Statusleiste berichtet davon und kann es beenden</translation>
    </message>
    <message>
      <source>Redraw all</source>
      <translation>Alle neu zeichnen</translation>
    </message>
  </context>
  <context>
    <name>Burin_Section</name>
    <message>
      <source>Cuts the parts open by planes in the drawing; the model stays as it is</source>
      <translation>Schneidet die Teile in der Zeichnung durch Ebenen auf; das Modell bleibt, wie es ist</translation>
    </message>
    <message>
      <source>Section</source>
      <translation>Schnitt</translation>
    </message>
  </context>
  <context>
    <name>Burin_SectionView</name>
    <message>
      <source>Adds a section A-A as a view of its own to the sheet: through the selected flat face or datum plane, else across y through the middle; the other views stay whole</source>
      <translation>Fügt dem Blatt einen Schnitt A-A als eigene Ansicht hinzu: durch die gewählte ebene Fläche oder Bezugsebene, sonst quer zu y durch die Mitte; die anderen Ansichten bleiben ganz</translation>
    </message>
    <message>
      <source>Section view</source>
      <translation>Schnittansicht</translation>
    </message>
  </context>
  <context>
    <name>Burin_SelectSource</name>
    <message>
      <source>Click a line of the illustration in the 3-D view: the edge or face that made it is selected. Esc ends.</source>
      <translation>Eine Linie der Illustration in der 3D-Ansicht anklicken: ihre Kante oder Fläche wird ausgewählt. Esc beendet.</translation>
    </message>
    <message>
      <source>Select source of a line</source>
      <translation>Ursprung einer Linie wählen</translation>
    </message>
  </context>
  <context>
    <name>Burin_ShowLines</name>
    <message>
      <source>Select an illustration and faces, edges or objects: the lines that they made light up</source>
      <translation>Eine Illustration und Flächen, Kanten oder Objekte wählen: ihre Linien leuchten auf</translation>
    </message>
    <message>
      <source>Show lines of a face or edge</source>
      <translation>Linien einer Fläche oder Kante zeigen</translation>
    </message>
  </context>
  <context>
    <name>Burin_StepBook</name>
    <message>
      <source>Step book...</source>
      <translation>Montagebuch...</translation>
    </message>
    <message>
      <source>Writes how the assembly is put together, a page a step, by the steps of its exploded view: PDF, a page for the web, or Markdown; the status bar shows progress and can end it</source>
      <translation>Schreibt, wie die Baugruppe zusammengesetzt wird, eine Seite je Schritt, nach den Schritten ihrer Explosionsansicht: PDF, eine Seite fürs Web oder Markdown; die Statusleiste zeigt es und kann es beenden</translation>
    </message>
  </context>
  <context>
    <name>Burin_Style</name>
    <message>
      <source>Chooses a style and edits its keys, shown as they change; saves it as a file</source>
      <translation>Wählt einen Stil und ändert seine Schlüssel, sofort gezeigt; speichert ihn als Datei</translation>
    </message>
    <message>
      <source>Style</source>
      <translation>Stil</translation>
    </message>
  </context>
  <context>
    <name>Burin_View</name>
    <message>
      <source>From where the illustration is seen</source>
      <translation>Von wo die Illustration gesehen wird</translation>
    </message>
    <message>
      <source>View</source>
      <translation>Ansicht</translation>
    </message>
  </context>
  <context>
    <name>Burin_ViewBack</name>
    <message>
      <source>Back</source>
      <translation>Hinten</translation>
    </message>
    <message>
      <source>The illustration looks from the back</source>
      <translation>Die Illustration blickt von hinten</translation>
    </message>
  </context>
  <context>
    <name>Burin_ViewBottom</name>
    <message>
      <source>Bottom</source>
      <translation>Unten</translation>
    </message>
    <message>
      <source>The illustration looks from below</source>
      <translation>Die Illustration blickt von unten</translation>
    </message>
  </context>
  <context>
    <name>Burin_ViewDimetric</name>
    <message>
      <source>Dimetric</source>
      <translation>Dimetrisch</translation>
    </message>
    <message>
      <source>The illustration looks almost from the front: depths are halved, as ISO 5456-3 has it</source>
      <translation>Die Illustration blickt fast von vorn: Tiefen sind halbiert, wie in ISO 5456-3</translation>
    </message>
  </context>
  <context>
    <name>Burin_ViewFromCamera</name>
    <message>
      <source>As in the 3-D view</source>
      <translation>Wie in der 3D-Ansicht</translation>
    </message>
    <message>
      <source>Draws the illustration as the 3-D view shows the model now, in perspective too</source>
      <translation>Zeichnet die Illustration so, wie die 3D-Ansicht das Modell jetzt zeigt, auch in Perspektive</translation>
    </message>
  </context>
  <context>
    <name>Burin_ViewFromFace</name>
    <message>
      <source>Select an illustration and a face: the illustration looks square onto the face</source>
      <translation>Eine Illustration und eine Fläche wählen: die Illustration blickt senkrecht auf die Fläche</translation>
    </message>
    <message>
      <source>Square onto a face</source>
      <translation>Senkrecht auf eine Fläche</translation>
    </message>
  </context>
  <context>
    <name>Burin_ViewFront</name>
    <message>
      <source>Front</source>
      <translation>Vorne</translation>
    </message>
    <message>
      <source>The illustration looks from the front (along y)</source>
      <translation>Die Illustration blickt von vorn (entlang y)</translation>
    </message>
  </context>
  <context>
    <name>Burin_ViewIsometric</name>
    <message>
      <source>Isometric</source>
      <translation>Isometrisch</translation>
    </message>
    <message>
      <source>The illustration looks from the front, the right and above at once</source>
      <translation>Die Illustration blickt von vorn, rechts und oben zugleich</translation>
    </message>
  </context>
  <context>
    <name>Burin_ViewLeft</name>
    <message>
      <source>Left</source>
      <translation>Links</translation>
    </message>
    <message>
      <source>The illustration looks from the left</source>
      <translation>Die Illustration blickt von links</translation>
    </message>
  </context>
  <context>
    <name>Burin_ViewRight</name>
    <message>
      <source>Right</source>
      <translation>Rechts</translation>
    </message>
    <message>
      <source>The illustration looks from the right</source>
      <translation>Die Illustration blickt von rechts</translation>
    </message>
  </context>
  <context>
    <name>Burin_ViewTop</name>
    <message>
      <source>The illustration looks from above</source>
      <translation>Die Illustration blickt von oben</translation>
    </message>
    <message>
      <source>Top</source>
      <translation>Oben</translation>
    </message>
  </context>
  <context>
    <name>Burin_ViewTrimetric</name>
    <message>
      <source>The illustration looks from the front, the right and above, at each by another angle</source>
      <translation>Die Illustration blickt von vorn, rechts und oben, jeweils unter einem anderen Winkel</translation>
    </message>
    <message>
      <source>Trimetric</source>
      <translation>Trimetrisch</translation>
    </message>
  </context>
  <context>
    <name>Workbench</name>
    <message>
      <source>&amp;Burin</source>
      <translation>&amp;Burin</translation>
    </message>
    <message>
      <source>Burin</source>
      <translation>Burin</translation>
    </message>
  </context>
</TS>
