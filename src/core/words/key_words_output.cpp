// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "core/words/word_row.h"

namespace frana {
namespace {

constexpr auto k_key_words_output = std::to_array<WordRow>({
    {"Result directory; --out overrides it.", "Cartella dei risultati; --out prevale.",
     "Ordner des Ergebnisses; --out geht vor.", "Dossier des résultats\u202F; --out prime.",
     "Carpeta de resultados; --out prevalece."},
    {"Maps to draw; on: all of the result.", "Mappe da disegnare; on: tutte quelle del risultato.",
     "Zu zeichnende Karten; on: alle des Ergebnisses.", "Cartes à dessiner\u202F; on\u202F: toutes celles du résultat.",
     "Mapas que se dibujan; on: todos los del resultado."},
    {"Write depth and velocity at the frame interval as GeoTIFFs.",
     "Scrivere profondità e velocità delle istantanee come GeoTIFF.",
     "Tiefe und Geschwindigkeit der Momentaufnahmen als GeoTIFF schreiben.",
     "Écrire hauteur et vitesse des instantanés en GeoTIFF.",
     "Escribir profundidad y velocidad de las instantáneas como GeoTIFF."},
    {"Write animation.mp4.", "Scrivere animation.mp4.", "animation.mp4 schreiben.", "Écrire animation.mp4.",
     "Escribir animation.mp4."},
    {"Formats: GeoTIFF is always written; netcdf and zarr add the frames as one file each, particles-gpkg and "
     "particles-vtp the particles of each frame as GeoPackage points and VTK polydata; ascii writes the AvaFrame "
     "rasters as ESRI ASCII grids.",
     "Formati: il GeoTIFF è sempre scritto; netcdf e zarr aggiungono le istantanee in un file ciascuno, particles-gpkg "
     "e particles-vtp le particelle di ogni istantanea come punti GeoPackage e polydata VTK; ascii scrive i raster di "
     "AvaFrame come griglie ESRI ASCII.",
     "Formate: GeoTIFF wird immer geschrieben; netcdf und zarr fügen die Momentaufnahmen in je einer Datei hinzu, "
     "particles-gpkg und particles-vtp die Partikel jeder Momentaufnahme als Punkte im GeoPackage und VTK-Polydata; "
     "ascii schreibt die AvaFrame-Raster als ESRI-ASCII-Gitter.",
     "Formats\u202F: le GeoTIFF est toujours écrit\u202F; netcdf et zarr ajoutent les instantanés en un fichier "
     "chacun, particles-gpkg et particles-vtp les particules de chaque instantané en points GeoPackage et polydata "
     "VTK\u202F; ascii écrit les rasters d’AvaFrame en grilles ESRI ASCII.",
     "Formatos: el GeoTIFF se escribe siempre; netcdf y zarr añaden las instantáneas en un archivo cada uno, "
     "particles-gpkg y particles-vtp las partículas de cada instantánea como puntos GeoPackage y polydata VTK; ascii "
     "escribe los rásteres de AvaFrame como mallas ESRI ASCII."},
    {"Wall time between checkpoints for --resume; 0: only at the run's last step.",
     "Tempo reale fra i punti di ripresa per --resume; 0: solo all’ultimo passo del calcolo.",
     "Rechenzeit zwischen den Sicherungen für --resume; 0: nur beim letzten Schritt der Rechnung.",
     "Temps réel entre les points de reprise pour --resume\u202F; 0\u202F: seulement au dernier pas du calcul.",
     "Tiempo real entre puntos de reanudación para --resume; 0: solo en el último paso del cálculo."},
    {"Depth above which ground counts as covered in outlines, covered area and run-out.",
     "Profondità oltre la quale il terreno conta come coperto in perimetri, area coperta e distanza di propagazione.",
     "Tiefe, ab der Gelände in Umrissen, bedeckter Fläche und Auslauflänge als bedeckt gilt.",
     "Hauteur au-delà de laquelle le terrain compte comme couvert dans les contours, la surface couverte et la "
     "distance de propagation.",
     "Profundidad a partir de la cual el terreno cuenta como cubierto en contornos, área cubierta y alcance."},
    {"Direction in which the flow's depth is measured in rasters, maps, classes and thresholds: vertical, or normal to "
     "the bed. Gauges and cross-sections are always vertical.",
     "Direzione in cui si misura la profondità della colata in raster, mappe, classi e soglie: verticale o normale al "
     "letto. Punti di misura e sezioni sono sempre verticali.",
     "Richtung, in der die Fließtiefe in Rastern, Karten, Klassen und Schwellen gemessen wird: vertikal oder normal "
     "zum Bett. Messpunkte und Querschnitte sind immer vertikal.",
     "Direction dans laquelle la hauteur d’écoulement est mesurée dans les rasters, cartes, classes et seuils\u202F: "
     "verticale ou normale au lit. Les points de mesure et les sections sont toujours verticaux.",
     "Dirección en que se mide la profundidad del flujo en rásteres, mapas, clases y umbrales: vertical o normal al "
     "lecho. Los puntos de medición y las secciones son siempre verticales."},
    {"avaframe: also write peakFiles/ with pressure, thickness normal to the slope and speed under AvaFrame's names.",
     "avaframe: scrivere anche peakFiles/ con pressione, spessore normale al versante e velocità con i nomi di "
     "AvaFrame.",
     "avaframe: auch peakFiles/ mit Druck, Mächtigkeit senkrecht zum Hang und Geschwindigkeit unter den Namen von "
     "AvaFrame schreiben.",
     "avaframe\u202F: écrire aussi peakFiles/ avec pression, épaisseur normale à la pente et vitesse sous les noms "
     "d’AvaFrame.",
     "avaframe: escribir también peakFiles/ con presión, espesor normal a la ladera y velocidad con los nombres de "
     "AvaFrame."},
    {"What the rasters of a finished result cover: the whole map, or the rectangle round everything released, reached "
     "or surveyed, with a margin; auto: reached on maps of over 1 million cells.",
     "Che cosa coprono i raster di un risultato finito: tutta la mappa, o il rettangolo attorno a quanto è staccato, "
     "raggiunto o rilevato, con un margine; auto: reached su mappe di oltre 1 milione di celle.",
     "Was die Raster eines fertigen Ergebnisses abdecken: die ganze Karte oder das Rechteck um alles Losgebrochene, "
     "Erreichte oder Kartierte, mit Rand; auto: reached auf Karten von über 1 Million Zellen.",
     "Ce que couvrent les rasters d’un résultat achevé\u202F: toute la carte, ou le rectangle autour de tout ce qui "
     "est parti, atteint ou levé, avec une marge\u202F; auto\u202F: reached sur les cartes de plus de 1 million de "
     "mailles.",
     "Qué cubren los rásteres de un resultado terminado: todo el mapa, o el rectángulo alrededor de lo liberado, "
     "alcanzado o levantado, con un margen; auto: reached en mapas de más de 1 millón de celdas."},
    {"Write report.html: maps, parameters, inputs, results and warnings in one file.",
     "Scrivere report.html: mappe, parametri, dati di ingresso, risultati e avvisi in un solo file.",
     "report.html schreiben: Karten, Parameter, Eingaben, Ergebnisse und Warnungen in einer Datei.",
     "Écrire report.html\u202F: cartes, paramètres, entrées, résultats et avertissements en un seul fichier.",
     "Escribir report.html: mapas, parámetros, entradas, resultados y advertencias en un solo archivo."},
    {"Points where depth and speed are recorded over time, in their own CRS.",
     "Punti in cui profondità e velocità sono registrate nel tempo, nel proprio SR.",
     "Punkte, an denen Tiefe und Geschwindigkeit über der Zeit aufgezeichnet werden, in eigenem KBS.",
     "Points où hauteur et vitesse sont enregistrées dans le temps, dans leur propre SCR.",
     "Puntos en los que se registran profundidad y velocidad en el tiempo, en su propio SRC."},
    {"Lines through which the discharge is recorded over time, in their own CRS.",
     "Linee attraverso le quali è registrata la portata nel tempo, nel proprio SR.",
     "Linien, durch die der Abfluss über der Zeit aufgezeichnet wird, in eigenem KBS.",
     "Lignes à travers lesquelles le débit est enregistré dans le temps, dans leur propre SCR.",
     "Líneas a través de las cuales se registra el caudal en el tiempo, en su propio SRC."},
    {"Simulated time between rows of gauges and cross-sections.",
     "Tempo simulato fra le righe di punti di misura e sezioni.",
     "Simulierte Zeit zwischen den Zeilen der Messpunkte und Querschnitte.",
     "Temps simulé entre les lignes des points de mesure et des sections.",
     "Tiempo simulado entre filas de puntos de medida y secciones."},
    {"Lines along which profiles of the results are written, in their own CRS; the profile along the flow path is "
     "always written.",
     "Linee lungo le quali sono scritti profili dei risultati, nel proprio SR; il profilo lungo il percorso della "
     "colata "
     "è sempre scritto.",
     "Linien, entlang derer Längenprofile der Ergebnisse geschrieben werden, in eigenem KBS; das entlang des Fließwegs "
     "wird immer geschrieben.",
     "Lignes le long desquelles des profils des résultats sont écrits, dans leur propre SCR\u202F; le profil le long "
     "du trajet de l’écoulement est toujours écrit.",
     "Líneas a lo largo de las cuales se escriben perfiles de los resultados, en su propio SRC; el perfil a lo largo "
     "del trayectoria del flujo se escribe siempre."},
    {"Buildings, roads, people: points, lines or areas in their own CRS, for each of which the greatest depth, speed "
     "and pressure and the arrival are written.",
     "Edifici, strade, persone: punti, linee o aree nel proprio SR, per ciascuno dei quali sono scritte profondità, "
     "velocità e pressione massime e l’arrivo.",
     "Gebäude, Straßen, Personen: Punkte, Linien oder Flächen in eigenem KBS, für die jeweils größte Tiefe, "
     "Geschwindigkeit und Druck sowie die Ankunft geschrieben werden.",
     "Bâtiments, routes, personnes\u202F: points, lignes ou surfaces dans leur propre SCR, pour chacun desquels sont "
     "écrits hauteur, vitesse et pression maximales et l’arrivée.",
     "Edificios, carreteras, personas: puntos, líneas o áreas en su propio SRC, para cada uno de los cuales se "
     "escriben profundidad, velocidad y presión máximas y la llegada."},
    {"Column of output.exposure with the name of each feature.",
     "Colonna di output.exposure con il nome di ogni elemento.",
     "Spalte von output.exposure mit dem Namen jedes Objekts.",
     "Colonne de output.exposure avec le nom de chaque élément.",
     "Columna de output.exposure con el nombre de cada elemento."},
    {"Column of output.exposure with how many each feature stands for (people, dwellings).",
     "Colonna di output.exposure con quanti ne rappresenta ogni elemento (persone, abitazioni).",
     "Spalte von output.exposure mit der Anzahl, für die jedes Objekt steht (Personen, Wohnungen).",
     "Colonne de output.exposure avec le nombre que représente chaque élément (personnes, logements).",
     "Columna de output.exposure con cuántos representa cada elemento (personas, viviendas)."},
    {"`frana ensemble`: maximum depths whose probability of being exceeded is mapped.",
     "`frana ensemble`: profondità massime di cui è mappata la probabilità di superamento.",
     "`frana ensemble`: maximale Tiefen, deren Überschreitungswahrscheinlichkeit kartiert wird.",
     "`frana ensemble`\u202F: hauteurs maximales dont la probabilité de dépassement est cartographiée.",
     "`frana ensemble`: profundidades máximas cuya probabilidad de excedencia se representa."},
    {"`frana ensemble`: maximum speeds whose probability of being exceeded is mapped.",
     "`frana ensemble`: velocità massime di cui è mappata la probabilità di superamento.",
     "`frana ensemble`: maximale Geschwindigkeiten, deren Überschreitungswahrscheinlichkeit kartiert wird.",
     "`frana ensemble`\u202F: vitesses maximales dont la probabilité de dépassement est cartographiée.",
     "`frana ensemble`: velocidades máximas cuya probabilidad de excedencia se representa."},
    {"`frana ensemble`: maximum dynamic pressures whose probability of being exceeded is mapped.",
     "`frana ensemble`: pressioni dinamiche massime di cui è mappata la probabilità di superamento.",
     "`frana ensemble`: maximale dynamische Drücke, deren Überschreitungswahrscheinlichkeit kartiert wird.",
     "`frana ensemble`\u202F: pressions dynamiques maximales dont la probabilité de dépassement est cartographiée.",
     "`frana ensemble`: presiones dinámicas máximas cuya probabilidad de excedencia se representa."},
    {"Scheme of intensity classes for hazard.tif; sources in share/doc/hazard.md.",
     "Schema delle classi di intensità per hazard.tif; fonti in share/doc/hazard.md.",
     "Schema der Intensitätsklassen für hazard.tif; Quellen in share/doc/hazard.md.",
     "Schéma des classes d’intensité pour hazard.tif\u202F; sources dans share/doc/hazard.md.",
     "Esquema de clases de intensidad para hazard.tif; fuentes en share/doc/hazard.md."},
    {"Depth above which ground has a class.", "Profondità oltre la quale il terreno ha una classe.",
     "Tiefe, über der das Gelände eine Klasse hat.", "Hauteur au-delà de laquelle le terrain a une classe.",
     "Profundidad por encima de la cual el terreno tiene una clase."},
    {"Scheme custom: limits of the maximum depth; the class rises by one at each.",
     "Schema custom: limiti della profondità massima; a ciascuno la classe sale di uno.",
     "Schema custom: Grenzen der maximalen Tiefe; an jeder steigt die Klasse um eins.",
     "Schéma custom\u202F: limites de la hauteur maximale\u202F; la classe monte d’un à chacune.",
     "Esquema custom: límites de la profundidad máxima; en cada uno la clase sube en uno."},
    {"Scheme custom: the same for the maximum speed.", "Schema custom: lo stesso per la velocità massima.",
     "Schema custom: dasselbe für die maximale Geschwindigkeit.",
     "Schéma custom\u202F: de même pour la vitesse maximale.", "Esquema custom: lo mismo para la velocidad máxima."},
    {"Scheme custom: the same for the maximum of depth times speed at one moment.",
     "Schema custom: lo stesso per il massimo di profondità per velocità nello stesso istante.",
     "Schema custom: dasselbe für das Maximum von Tiefe mal Geschwindigkeit zu einem Zeitpunkt.",
     "Schéma custom\u202F: de même pour le maximum de hauteur fois vitesse au même instant.",
     "Esquema custom: lo mismo para el máximo de profundidad por velocidad en un mismo instante."},
    {"Scheme custom: the same for the maximum dynamic pressure.",
     "Schema custom: lo stesso per la pressione dinamica massima.",
     "Schema custom: dasselbe für den maximalen dynamischen Druck.",
     "Schéma custom\u202F: de même pour la pression dynamique maximale.",
     "Esquema custom: lo mismo para la presión dinámica máxima."},
    {"Surveyed outline to compare with: any polygon layer, in its own CRS.",
     "Perimetro rilevato con cui confrontare: qualsiasi layer di poligoni, nel proprio SR.",
     "Kartierter Umriss, mit dem verglichen wird: jede Polygonebene, in eigenem KBS.",
     "Contour levé auquel comparer\u202F: toute couche de polygones, dans son propre SCR.",
     "Contorno levantado con el que se compara: cualquier capa de polígonos, en su propio SRC."},
    {"Surveyed lines of a front, or points of a deposit's tip, in their own CRS.",
     "Linee rilevate di un fronte, o punti della punta di un deposito, nel proprio SR.",
     "Kartierte Linien einer Front oder Punkte der Spitze einer Ablagerung, in eigenem KBS.",
     "Lignes levées d’un front, ou points de la pointe d’un dépôt, dans leur propre SCR.",
     "Líneas levantadas de un frente, o puntos de la punta de un depósito, en su propio SRC."},
    {"Surveyed deposit: polygons, or a raster of elevation after minus before.",
     "Deposito rilevato: poligoni, o un raster della quota dopo meno prima.",
     "Kartierte Ablagerung: Polygone oder ein Raster der Höhe nachher minus vorher.",
     "Dépôt levé\u202F: polygones, ou un raster de l’altitude après moins avant.",
     "Depósito levantado: polígonos, o un ráster de la cota posterior menos la anterior."},
    {"Depth above which ground counts as covered in the comparison.",
     "Profondità oltre la quale il terreno conta come coperto nel confronto.",
     "Tiefe, ab der Gelände im Vergleich als bedeckt gilt.",
     "Hauteur au-delà de laquelle le terrain compte comme couvert dans la comparaison.",
     "Profundidad a partir de la cual el terreno cuenta como cubierto en la comparación."},
});

}  // namespace

std::span<const WordRow> key_words_output() {
    return k_key_words_output;
}

}  // namespace frana
