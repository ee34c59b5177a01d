#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""python_reference.py [--check]: writes docs/python.md, the reference of the Python module, from its docstrings. With --check
nothing is written. Exit codes: 0 fine, 1 the page is not what the docstrings say, or something public has none."""
import ast
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PACKAGE = ROOT / "python" / "umbrameter"
PAGE = ROOT / "docs" / "python.md"
HEAD = """# Python reference

Made by `scripts/python_reference.py` from the docstrings; [api.md](api.md) says how to begin, and
[notebooks](../python/notebooks) show whole studies.
"""
MODULES = (("umbrameter", "__init__.py"), ("umbrameter.figures", "figures.py"), ("umbrameter.tables", "tables.py"))


def parsed(name):
    return ast.parse((PACKAGE / name).read_text())


def exported(tree):
    """The names of __all__."""
    return next([element.value for element in node.value.elts] for node in tree.body
                if isinstance(node, ast.Assign) and node.targets[0].id == "__all__")


def defined(tree):
    """Name -> (node, the string after it) of what a module's body defines."""
    found = {}
    for node, after in zip(tree.body, [*tree.body[1:], None]):
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            found[node.name] = (node, ast.get_docstring(node))
        elif isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
            found[node.target.id] = (node, string_of(after))
    return found


def string_of(node):
    is_string = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str)
    return " ".join(node.value.value.split()) if is_string else None


def imported(tree):
    """Name -> (file, name there) of what is taken from the package's own modules."""
    return {alias.asname or alias.name: (f"{node.module}.py", alias.name) for node in tree.body
            if isinstance(node, ast.ImportFrom) and node.level == 1 and node.module for alias in node.names}


def look_up(name, tree):
    here = defined(tree)
    if name in here:
        return here[name]
    file, there = imported(tree)[name]
    file = file if (PACKAGE / file).exists() else file + "i"
    return defined(parsed(file))[there]


def signature(function, skip_self=False):
    """Without annotations of what the text says anyway: names and defaults."""
    arguments = function.args
    plain = arguments.args[1:] if skip_self else arguments.args
    defaults = [None] * (len(plain) - len(arguments.defaults)) + arguments.defaults
    words = [word(argument, default) for argument, default in zip(plain, defaults)]
    if arguments.kwonlyargs:
        words += ["*"] + [word(argument, default) for argument, default in zip(arguments.kwonlyargs, arguments.kw_defaults)]
    if arguments.vararg:
        words.append("*" + arguments.vararg.arg)
    if arguments.kwarg:
        words.append("**" + arguments.kwarg.arg)
    return ", ".join(words)


def word(argument, default):
    return argument.arg if default is None else f"{argument.arg}={ast.unparse(default)}"


def is_property(function):
    return any(isinstance(one, ast.Name) and one.id == "property" for one in function.decorator_list)


def text_of_class(name, node, doc, problems):
    lines = [f"### `{name}`", "", doc or "", ""]
    for member, after in zip(node.body, [*node.body[1:], None]):
        said = None
        if isinstance(member, ast.FunctionDef) and not member.name.startswith("_"):
            said = f"`{member.name}`" if is_property(member) else f"`{member.name}({signature(member, True)})`"
            said_doc = ast.get_docstring(member)
        elif isinstance(member, ast.AnnAssign) and not member.target.id.startswith("_"):
            said, said_doc = f"`{member.target.id}`", string_of(after)
        if said:
            lines.append(f"- {said}" + (f": {' '.join(said_doc.split())}" if said_doc else ""))
    if not doc:
        problems.append(f"{name} has no docstring")
    return lines + [""]


def text_of(name, tree, problems):
    node, doc = look_up(name, tree)
    if isinstance(node, ast.ClassDef):
        return text_of_class(name, node, doc, problems)
    if not doc:
        problems.append(f"{name} has no docstring")
    head = f"### `{name}({signature(node)})`" if isinstance(node, ast.FunctionDef) else f"### `{name}`"
    return [head, "", doc or "", ""]


def page(problems):
    lines = [HEAD]
    for module, file in MODULES:
        tree = parsed(file)
        lines += [f"## {module}", "", *ast.get_docstring(tree).splitlines(), ""]
        for name in (name for name in exported(tree) if name != "__version__"):
            lines += text_of(name, tree, problems)
    return "\n".join(lines).rstrip() + "\n"


def main():
    problems = []
    text = page(problems)
    if "--check" not in sys.argv:
        PAGE.write_text(text)
    elif not PAGE.exists() or PAGE.read_text() != text:
        problems.append("docs/python.md is not what the docstrings say: run scripts/python_reference.py")
    for problem in problems:
        print(f"python_reference: {problem}", file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
