<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
  <context>
    <name>Burin</name>
    <message>
      <source>3-D view</source>
      <translation>3D-Ansicht</translation>
    </message>
    <message>
      <source>A built-in style, or a style file</source>
      <translation>Ein eingebauter Stil oder eine Stildatei</translation>
    </message>
    <message>
      <source>Add strokes…</source>
      <translation>Striche hinzufügen …</translation>
    </message>
    <message>
      <source>Back</source>
      <translation>Hinten</translation>
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
      <source>Chooses a style file</source>
      <translation>Wählt eine Stildatei</translation>
    </message>
    <message>
      <source>Click a line of the illustration; Esc ends</source>
      <translation>Eine Linie der Illustration anklicken; Esc beendet</translation>
    </message>
    <message>
      <source>Dimetric</source>
      <translation>Dimetrisch</translation>
    </message>
    <message>
      <source>Draws strokes of another kind over those that there are</source>
      <translation>Zeichnet Striche einer anderen Art über die vorhandenen</translation>
    </message>
    <message>
      <source>Draws the illustration as the 3-D view shows the model now, in perspective too</source>
      <translation>Zeichnet die Illustration so, wie die 3D-Ansicht das Modell jetzt zeigt, auch in Perspektive</translation>
    </message>
    <message>
      <source>Edit illustration</source>
      <translation>Illustration bearbeiten</translation>
    </message>
    <message>
      <source>Ends the run; the drawing shown stays the one before</source>
      <translation>Beendet den Lauf; gezeigt bleibt die vorige Zeichnung</translation>
    </message>
    <message>
      <source>Filter</source>
      <translation>Filter</translation>
    </message>
    <message>
      <source>Fit</source>
      <translation>Einpassen</translation>
    </message>
    <message>
      <source>Follow the 3-D view</source>
      <translation>Der 3-D-Ansicht folgen</translation>
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
      <source>How hidden lines are drawn</source>
      <translation>Wie verdeckte Linien gezeichnet werden</translation>
    </message>
    <message>
      <source>Illustration files</source>
      <translation>Illustrationsdateien</translation>
    </message>
    <message>
      <source>Isometric</source>
      <translation>Isometrisch</translation>
    </message>
    <message>
      <source>Key</source>
      <translation>Schlüssel</translation>
    </message>
    <message>
      <source>Left</source>
      <translation>Links</translation>
    </message>
    <message>
      <source>Millimetres of paper for a millimetre of the model</source>
      <translation>Millimeter Papier für einen Millimeter des Modells</translation>
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
      <source>Object</source>
      <translation>Objekt</translation>
    </message>
    <message>
      <source>Object of the model</source>
      <translation>Objekt des Modells</translation>
    </message>
    <message>
      <source>Objects</source>
      <translation>Objekte</translation>
    </message>
    <message>
      <source>Open…</source>
      <translation>Öffnen</translation>
    </message>
    <message>
      <source>Own style</source>
      <translation>Eigener Stil</translation>
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
      <source>Perspective</source>
      <translation>Perspektive</translation>
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
      <source>Seed</source>
      <translation>Startzahl</translation>
    </message>
    <message>
      <source>Seed of all that is left to chance: another one gives other strokes</source>
      <translation>Startzahl für alles Zufällige: eine andere gibt andere Striche</translation>
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
      <source>Standard views</source>
      <translation>Standardansichten</translation>
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
      <source>Take back</source>
      <translation>Zurücknehmen</translation>
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
      <source>The drawing as it is now; a click shows it large</source>
      <translation>Die Zeichnung, wie sie jetzt ist; ein Klick zeigt sie groß</translation>
    </message>
    <message>
      <source>The drawing kernel is not installed.</source>
      <translation>Der Zeichenkern ist nicht installiert.</translation>
    </message>
    <message>
      <source>This FreeCAD takes {0} pixels of a symbol for a millimetre; illustrations on pages were made anew for it</source>
      <translation>Dieses FreeCAD nimmt {0} Pixel eines Symbols für einen Millimeter; Illustrationen auf Seiten wurden dafür neu gemacht</translation>
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
      <source>Vertical field of view, {0:g} to {1:g} degrees</source>
      <translation>Senkrechter Bildwinkel, {0:g} bis {1:g} Grad</translation>
    </message>
    <message>
      <source>View</source>
      <translation>Ansicht</translation>
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
      <source>all feature lines, hidden ones too: haloes and widths alone tell depth</source>
      <translation>alle Formlinien, auch verdeckte: nur Höfe und Strichbreiten zeigen die Tiefe</translation>
    </message>
    <message>
      <source>another panel is open; close it first</source>
      <translation>ein anderes Fenster ist offen; schließen Sie es zuerst</translation>
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
      <source>bold: few broad strokes that swell from white to almost black</source>
      <translation>kräftig: wenige breite Striche, die von Weiß bis fast Schwarz anschwellen</translation>
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
      <source>drawing</source>
      <translation>wird gezeichnet</translation>
    </message>
    <message>
      <source>drawn</source>
      <translation>gezeichnet</translation>
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
      <source>landscape</source>
      <translation>quer</translation>
    </message>
    <message>
      <source>light strokes; lines behind others stand clear of them, far lines are thin</source>
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
      <source>none</source>
      <translation>keine</translation>
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
      <source>one pen: lines of one width as plain polylines, closer where it is dark</source>
      <translation>ein Stift: Linien einer Breite als einfache Linienzüge, dichter im Dunkeln</translation>
    </message>
    <message>
      <source>plain</source>
      <translation>schlicht</translation>
    </message>
    <message>
      <source>portrait</source>
      <translation>hoch</translation>
    </message>
    <message>
      <source>read</source>
      <translation>Lesen</translation>
    </message>
    <message>
      <source>select a face too</source>
      <translation>wählen Sie auch eine Fläche</translation>
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
      <source>select one illustration</source>
      <translation>wählen Sie eine Illustration</translation>
    </message>
    <message>
      <source>select one illustration that is drawn</source>
      <translation>wählen Sie eine Illustration, die gezeichnet ist</translation>
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
      <source>stopping</source>
      <translation>wird angehalten</translation>
    </message>
    <message>
      <source>strokes</source>
      <translation>Striche</translation>
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
      <source>verify</source>
      <translation>Prüfung</translation>
    </message>
    <message>
      <source>visibility</source>
      <translation>Sichtbarkeit</translation>
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
      <source>write</source>
      <translation>Schreiben</translation>
    </message>
    <message>
      <source>{0} has no drawing that can be read ({1}); recompute it</source>
      <translation>{0} hat keine lesbare Zeichnung ({1}); berechnen Sie sie neu</translation>
    </message>
    <message>
      <source>{0} is no longer in the document</source>
      <translation>{0} ist nicht mehr im Dokument</translation>
    </message>
    <message>
      <source>{0} lines</source>
      <translation>{0} Linien</translation>
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
      <source>Template of pages that Burin makes; empty = blank A3 landscape</source>
      <translation>Vorlage der Seiten, die Burin anlegt; leer = A3 quer ohne Rahmen</translation>
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
