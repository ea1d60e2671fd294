// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "core/words/word_row.h"

namespace frana {
namespace {

constexpr auto k_input_words = std::to_array<WordRow>({
    {"DTM", "DTM", "DGM", "MNT", "MDT"},
    {"Release thickness", "Spessore del distacco", "Anrissmächtigkeit", "Épaisseur au départ", "Espesor del inicio"},
    {"Release perimeter", "Perimetro del distacco", "Anrissumriss", "Contour de la zone de départ",
     "Contorno del inicio"},
    {"Surveyed deposit", "Deposito rilevato", "Kartierte Ablagerung", "Dépôt levé", "Depósito levantado"},
    {"Surveyed elevation change", "Variazione di quota rilevata", "Kartierte Höhenänderung",
     "Variation d’altitude levée", "Cambio de cota levantado"},
    {"Surveyed front", "Fronte rilevato", "Kartierte Front", "Front levé", "Frente levantado"},
    {"Map background", "Sfondo delle mappe", "Kartenhintergrund", "Fond des cartes", "Fondo de los mapas"},
    {"Logo", "Logo", "Logo", "Logo", "Logotipo"},
    {"Inflow line", "Linea di afflusso", "Zuflusslinie", "Ligne d’afflux", "Línea de entrada"},
    {"Hydrograph", "Idrogramma", "Ganglinie", "Hydrogramme", "Hidrograma"},
    {"Exposed features", "Elementi esposti", "Exponierte Objekte", "Éléments exposés", "Elementos expuestos"},
    {"Zones", "Zone", "Zonen", "Zones", "Zonas"},
    {"picture", "immagine", "Bild", "image", "imagen"},
    {"{1} line", "{1} linea", "{1} Linie", "{1} ligne", "{1} línea"},
    {"{1} lines", "{1} linee", "{1} Linien", "{1} lignes", "{1} líneas"},
    {"{1} polygon", "{1} poligono", "{1} Polygon", "{1} polygone", "{1} polígono"},
    {"{1} polygons", "{1} poligoni", "{1} Polygone", "{1} polygones", "{1} polígonos"},
    {"{1} point", "{1} punto", "{1} Punkt", "{1} point", "{1} punto"},
    {"{1} points", "{1} punti", "{1} Punkte", "{1} points", "{1} puntos"},
    {"{1} feature", "{1} elemento", "{1} Objekt", "{1} élément", "{1} elemento"},
    {"{1} features", "{1} elementi", "{1} Objekte", "{1} éléments", "{1} elementos"},
    {"{1} x {2} of", "{1} × {2} da", "{1} × {2} von", "{1} × {2} de", "{1} × {2} de"},
    {"{1} x {2}", "{1} × {2}", "{1} × {2}", "{1} × {2}", "{1} × {2}"},
    {"{1} x {2} degrees", "{1} × {2} gradi", "{1} × {2} Grad", "{1} × {2} degrés", "{1} × {2} grados"},
    {"{1} in {2}", "{1} in {2}", "{1} in {2}", "{1} en {2}", "{1} en {2}"},
    {"from {1}", "da {1}", "von {1}", "de {1}", "de {1}"},
    {"to {1} s", "a {1} s", "bis {1} s", "à {1} s", "a {1} s"},
    {"assumed", "presunto", "angenommen", "supposé", "supuesto"},
    {"rotated", "ruotato", "gedreht", "tourné", "girado"},
    {"metre", "metri", "Meter", "mètres", "metros"},
    {"decimetre", "decimetri", "Dezimeter", "décimètres", "decímetros"},
    {"centimetre", "centimetri", "Zentimeter", "centimètres", "centímetros"},
    {"millimetre", "millimetri", "Millimeter", "millimètres", "milímetros"},
    {"foot", "piedi", "Fuß", "pieds", "pies"},
    {"US survey foot", "piedi topografici USA", "US-Vermessungsfuß", "pieds d’arpentage américains",
     "pies topográficos de EE. UU."},
    {"west {1}, south {2}, east {3}, north {4}", "ovest {1}, sud {2}, est {3}, nord {4}",
     "West {1}, Süd {2}, Ost {3}, Nord {4}", "ouest {1}, sud {2}, est {3}, nord {4}",
     "oeste {1}, sur {2}, este {3}, norte {4}"},
    {"none needed", "non necessaria", "nicht nötig", "inutile", "no es necesaria"},
    {"{1}; accuracy unknown", "{1}; accuratezza sconosciuta", "{1}; Genauigkeit unbekannt",
     "{1}\u202F; exactitude inconnue", "{1}; exactitud desconocida"},
    {"{1}; exact", "{1}; esatta", "{1}; exakt", "{1}\u202F; exacte", "{1}; exacta"},
    {"{1}; accuracy {2} m", "{1}; accuratezza {2} m", "{1}; Genauigkeit {2} m", "{1}\u202F; exactitude {2} m",
     "{1}; exactitud {2} m"},
});

}  // namespace

std::span<const WordRow> input_words() {
    return k_input_words;
}

}  // namespace frana
