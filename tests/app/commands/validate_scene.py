# SPDX-License-Identifier: Apache-2.0
"""validate_scene.py SCHEMA SCENE.ini: validates a scene against the schema of `frana params --schema`, by the rule of
share/doc/scripts.md. Prints the number of problems and the path of each; 77: jsonschema is missing."""
import json
import sys

try:
    import jsonschema
except ImportError:
    sys.exit(77)


def number(text):
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return text


def as_json(text, schema):
    if schema.get("type") == "array":
        return [number(word) for word in text.replace(",", " ").split()]
    return text if schema.get("type") == "string" else number(text)


def scene_of(path, schema):
    scene, section = {}, None
    for line in open(path, encoding="utf-8"):
        line = line.strip()
        if not line or line.startswith("#"):
            continue
        if line.startswith("["):
            section = line[1:-1]
            scene.setdefault(section, {})
            continue
        key, value = (part.strip() for part in line.split("=", 1))
        declared = schema["properties"].get(section, {}).get("properties", {}).get(key, {})
        scene[section][key] = as_json(value.split(" #")[0], declared)
    return scene


schema = json.load(open(sys.argv[1], encoding="utf-8"))
jsonschema.Draft202012Validator.check_schema(schema)
problems = list(jsonschema.Draft202012Validator(schema).iter_errors(scene_of(sys.argv[2], schema)))
print(len(problems))
for problem in problems:
    print("/".join(str(part) for part in problem.absolute_path), problem.message[:80])
