"""Random calls of the command line, as what its `methods --json` and `tools --json` say allows."""
import json

# Of each tool that changes an exemplar, what its setting may be.
EDITS = {"crop": ["2,3,36,34"], "rotate": ["12.5", "90", "-7"], "flip": ["horizontal", "vertical"],
         "flatten": ["smooth", "polynomial"], "rectify": ["2,1,37,3,36,38,1,36"]}


def ports(method, which):
    return {port["id"]: port for port in method[which]}


def value_for(parameter, rng):
    """A value within a parameter's range, as JSON has it."""
    if parameter["type"] == "toggle":
        return rng.random() < 0.5
    if parameter["type"] == "choice":
        return rng.choice(parameter["choices"])["id"]
    low, high = parameter.get("range", (0, 100))
    low = max(low, -24)
    high = min(high, low + 24 if low >= 0 else 24)  # what is larger takes long or is refused
    return rng.randint(int(low), int(high)) if parameter["type"] == "integer" else round(rng.uniform(low, high), 3)


def as_text(value):
    return {True: "on", False: "off"}[value] if isinstance(value, bool) else str(value)


def settings_for(method, rng, share=0.3):
    """Values for some of the parameters; few iterations for every method that has them, since the defaults train for
    minutes."""
    values = {}
    for parameter in method["parameters"]:
        name = parameter["name"]
        if "iterations" in name:
            least = int(parameter["range"][0])
            values[name] = rng.randint(least, least + 5)
        elif name not in ("rounds", "pause") and parameter["type"] in ("toggle", "choice", "integer", "real") and \
                rng.random() < share:
            values[name] = value_for(parameter, rng)
    return values


def size_for(rng):
    return rng.randint(20, 96), rng.randint(20, 96)


def synth(method, then, exemplar, own, rng):
    """A call of `synth` with random settings. @param own whether the exemplar was made up, and has a mask.
    @param then a method that follows, or None."""
    size = "x".join(map(str, size_for(rng)))
    words = ["synth", method["id"], exemplar, "--size", size, "--seed", rng.randint(0, 1 << 40)]
    if ports(method, "gives")["image"]["wraps"] and rng.random() < 0.4:
        words += ["--wrap", rng.choice(["x", "y", "xy"])]
    for name, port in ports(method, "takes").items():
        if own and name == "mask" and rng.random() < 0.3:
            words += ["--mask", "mask.png"]
        elif name not in ("exemplar", "mask") and port["kind"] == "image" and port["extent"] != "output" and \
                port["least"] > 0:
            words += ["--input", f"{name}={exemplar}"]
    for name, value in settings_for(method, rng).items():
        words += ["--set", f"{name}={as_text(value)}"]
    if then:
        words += ["--then", then["id"]]
    if own and rng.random() < 0.2:
        edit = rng.choice(sorted(EDITS))
        words += ["--edit", f"{edit}={rng.choice(EDITS[edit])}"]
    return words


def join(tool, rng):
    """A call of a tool that joins two pictures."""
    words = [tool["id"], "exemplar.png", "second.png"]
    if tool["id"] != "blend" and rng.random() < 0.8:
        words += ["--mask", "region.png"]
    for parameter in tool["parameters"]:
        if parameter["type"] in ("toggle", "choice", "integer", "real") and rng.random() < 0.4:
            words += [f"--{parameter['name']}", as_text(value_for(parameter, rng))]
    return words


def batch(methods, rng):
    """The text of a batch of one or two runs, each of several seeds, perhaps at several sizes."""
    runs = []
    for number, method in enumerate(methods):
        recipe = {"texloom": 1, "method": method["id"], "parameters": settings_for(method, rng, 0.15),
                  "exemplars": [{"file": "exemplar.png"}] if "exemplar" in ports(method, "takes") else [],
                  "size": size_for(rng)}
        sweep = {"seed": [rng.randint(0, 99), rng.randint(100, 199)]}
        if rng.random() < 0.3:
            sweep["size"] = [size_for(rng), size_for(rng)]
        runs.append({"recipe": recipe, "sweep": sweep, "output": f"out_{number}_$index.png",
                     "seeds": rng.choice(["held", "varied"])})
    return json.dumps({"batch": 1, "runs": runs})
