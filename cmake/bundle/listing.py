"""What is inside a bundle or a wheel, as SPDX 2.3."""
import json
import re

from gather import commit_time, run, version


def listing(packages, compiled, licences):
    """The text of the list: Burin and the packages of Debian, {name: version}, whose libraries it loads, and those that are
    compiled in; their licences lie in a folder of that name."""
    when = run("date", "-u", "-d", f"@{commit_time()}", "+%Y-%m-%dT%H:%M:%SZ").strip()
    processor = run("dpkg", "--print-architecture").strip()
    own = {"SPDXID": "SPDXRef-burin", "name": "burin", "versionInfo": version(), "licenseConcluded": "GPL-3.0-or-later",
           "licenseDeclared": "GPL-3.0-or-later", "downloadLocation": "NOASSERTION", "filesAnalyzed": False}
    rows, relations = [own], [{"spdxElementId": "SPDXRef-DOCUMENT", "relationshipType": "DESCRIBES", "relatedSpdxElement": "SPDXRef-burin"}]
    for name, of in sorted({**packages, **compiled}.items()):
        key = "SPDXRef-" + re.sub(r"[^A-Za-z0-9.-]", "-", name)
        rows.append({"SPDXID": key, "name": name, "versionInfo": of, "downloadLocation": "NOASSERTION", "filesAnalyzed": False,
                     "licenseConcluded": "NOASSERTION", "licenseDeclared": "NOASSERTION",
                     "comment": f"from Debian; its licence is in {licences}/{name}",
                     "externalRefs": [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",
                                       "referenceLocator": f"pkg:deb/debian/{name}@{of}?arch={processor}"}]})
        relations.append({"spdxElementId": "SPDXRef-burin", "relationshipType": "STATIC_LINK" if name in compiled else "DYNAMIC_LINK", "relatedSpdxElement": key})
    return json.dumps({"spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": f"burin-{version()}",
                       "documentNamespace": f"urn:burin:{version()}:{when}",
                       "creationInfo": {"created": when, "creators": ["Tool: Burin's bundle"]},
                       "packages": rows, "relationships": relations}, indent=1) + "\n"
