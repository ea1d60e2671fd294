# SPDX-License-Identifier: Apache-2.0
"""The QGIS plugin of frana: a Processing provider that runs the program frana on layers of the project."""


def classFactory(iface):  # noqa: N802 (the name that QGIS calls)
    from .provider import FranaPlugin
    return FranaPlugin()
