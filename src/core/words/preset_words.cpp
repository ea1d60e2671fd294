// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "core/words/word_row.h"

namespace frana {
namespace {

constexpr auto k_preset_words = std::to_array<WordRow>({
    {"Bindo-Cortenova (Lombardy), landslide of December 2002, about 1.2 million m3.",
     "Bindo-Cortenova (Lombardia), frana del dicembre 2002, circa 1,2 milioni di m³.",
     "Bindo-Cortenova (Lombardei), Rutschung vom Dezember 2002, etwa 1,2 Millionen m³.",
     "Bindo-Cortenova (Lombardie), glissement de décembre 2002, environ 1,2 million de m³.",
     "Bindo-Cortenova (Lombardía), deslizamiento de diciembre de 2002, unos 1,2 millones de m³."},
    {"Source: Fois, de Falco, Formaggia 2024 (doi:10.1016/j.cnsns.2024.108202), the parameters of their simulation.",
     "Fonte: Fois, de Falco, Formaggia 2024 (doi:10.1016/j.cnsns.2024.108202), i parametri della loro simulazione.",
     "Quelle: Fois, de Falco, Formaggia 2024 (doi:10.1016/j.cnsns.2024.108202), die Parameter ihrer Simulation.",
     "Source\u202F: Fois, de Falco, Formaggia 2024 (doi:10.1016/j.cnsns.2024.108202), les paramètres de leur "
     "simulation.",
     "Fuente: Fois, de Falco, Formaggia 2024 (doi:10.1016/j.cnsns.2024.108202), los parámetros de su simulación."},
    {"Checked: all five values, against the text of that publication. It gives the yield stress in Pa s; Pa is meant.",
     "Verificati: tutti e cinque i valori, sul testo di quella pubblicazione. Essa dà la tensione di soglia in Pa s; "
     "si intende Pa.",
     "Geprüft: alle fünf Werte, am Text dieser Veröffentlichung. Sie gibt die Fließgrenze in Pa s an; gemeint ist Pa.",
     "Vérifié\u202F: les cinq valeurs, sur le texte de cette publication. Elle donne le seuil d’écoulement en Pa "
     "s\u202F; il s’agit de Pa.",
     "Comprobado: los cinco valores, con el texto de esa publicación. Da la tensión de fluencia en Pa s; se entiende "
     "Pa."},
    {"Range: chosen for this one event; not a general value for weathered rock.",
     "Campo di validità: scelti per questo solo evento; non valori generali per roccia alterata.",
     "Gültigkeit: für dieses eine Ereignis gewählt; keine allgemeinen Werte für verwitterten Fels.",
     "Domaine\u202F: choisies pour ce seul événement\u202F; non des valeurs générales pour une roche altérée.",
     "Validez: elegidos para este único evento; no son valores generales para roca meteorizada."},
    {"Granular debris flow in a channel or on a fan.", "Colata detritica granulare in un canale o su un conoide.",
     "Granularer Murgang in einem Gerinne oder auf einem Kegel.",
     "Lave torrentielle granulaire dans un chenal ou sur un cône.",
     "Flujo de detritos granular en un cauce o en un abanico."},
    {"Source: turbulence and density are the starting values of the open program DebrisFrame (OpenNHM, c1TIFCfg.ini), "
     "read there (marked as untested); its friction coefficient is 0.155. Friction coefficient: 0.2 is quoted from the "
     "manual of RAMMS::DEBRISFLOW (WSL/SLF). The manual was not at hand: take 0.2 as customary, not as confirmed.",
     "Fonte: turbolenza e densità sono i valori iniziali del programma aperto DebrisFrame (OpenNHM, c1TIFCfg.ini), "
     "letti lì (indicati come non verificati); il suo coefficiente di attrito è 0,155. Coefficiente di attrito: 0,2 è "
     "citato dal manuale di RAMMS::DEBRISFLOW (WSL/SLF). Il manuale non era a disposizione: 0,2 vale come consueto, "
     "non come confermato.",
     "Quelle: Turbulenz und Dichte sind die Startwerte des offenen Programms DebrisFrame (OpenNHM, c1TIFCfg.ini), dort "
     "gelesen (als ungeprüft bezeichnet); dessen Reibungsbeiwert ist 0,155. Reibungsbeiwert: 0,2 ist nach dem Handbuch "
     "von RAMMS::DEBRISFLOW (WSL/SLF) zitiert. Das Handbuch lag nicht vor: 0,2 gilt als üblich, nicht als bestätigt.",
     "Source\u202F: turbulence et masse volumique sont les valeurs de départ du programme libre DebrisFrame (OpenNHM, "
     "c1TIFCfg.ini), lues dans celui-ci (indiquées comme non vérifiées)\u202F; son coefficient de frottement est "
     "0,155. Coefficient de frottement\u202F: 0,2 est cité d’après le manuel de RAMMS::DEBRISFLOW (WSL/SLF). Le manuel "
     "n’était pas disponible\u202F: prendre 0,2 comme usuel, non comme confirmé.",
     "Fuente: turbulencia y densidad son los valores de partida del programa abierto DebrisFrame (OpenNHM, "
     "c1TIFCfg.ini), leídos en él (indicados como no comprobados); su coeficiente de fricción es 0,155. Coeficiente de "
     "fricción: 0,2 se cita del manual de RAMMS::DEBRISFLOW (WSL/SLF). El manual no estaba disponible: 0,2 vale como "
     "habitual, no como confirmado."},
    {"Range: friction coefficient 0.05 to 0.4 (about the tangent of the slope where deposits begin) and turbulence 100 "
     "to 200 m/s2 for granular flows are quoted from the same manual, not confirmed either. Back-analysis for the "
     "debris flow of 2010 in the Yindongzi gully: 0.1 and 1000 m/s2 (Abraham et al. 2022, model DFS 2D; abstract "
     "read).",
     "Campo di validità: coefficiente di attrito da 0,05 a 0,4 (circa la tangente della pendenza dove iniziano i "
     "depositi) e turbolenza da 100 a 200 m/s² per colate granulari sono citati dallo stesso manuale, anch’essi non "
     "confermati. Analisi a ritroso della colata detritica del 2010 nel vallone di Yindongzi: 0,1 e 1000 m/s² (Abraham "
     "et al. 2022, modello DFS 2D; letto il riassunto).",
     "Gültigkeit: Reibungsbeiwert 0,05 bis 0,4 (etwa der Tangens der Neigung, wo die Ablagerung beginnt) und Turbulenz "
     "100 bis 200 m/s² für granulare Murgänge sind nach demselben Handbuch zitiert, ebenfalls nicht bestätigt. "
     "Rückrechnung des Murgangs von 2010 im Yindongzi-Graben: 0,1 und 1000 m/s² (Abraham et al. 2022, Modell DFS 2D; "
     "Zusammenfassung gelesen).",
     "Domaine\u202F: coefficient de frottement de 0,05 à 0,4 (environ la tangente de la pente où commencent les "
     "dépôts) et turbulence de 100 à 200 m/s² pour les écoulements granulaires sont cités d’après le même manuel, non "
     "confirmés non plus. Rétro-analyse de la lave torrentielle de 2010 dans le ravin de Yindongzi\u202F: 0,1 et 1000 "
     "m/s² (Abraham et al. 2022, modèle DFS 2D\u202F; résumé lu).",
     "Validez: coeficiente de fricción de 0,05 a 0,4 (aproximadamente la tangente de la pendiente donde empiezan los "
     "depósitos) y turbulencia de 100 a 200 m/s² para flujos granulares se citan del mismo manual, tampoco "
     "confirmados. Retroanálisis del flujo de detritos de 2010 en el barranco de Yindongzi: 0,1 y 1000 m/s² (Abraham "
     "et al. 2022, modelo DFS 2D; resumen leído)."},
    {"Earthflow: clayey, wet, slow to moderate; a Bingham fluid on its bed.",
     "Colata di terra: argillosa, umida, da lenta a moderata; un fluido di Bingham sul suo fondo.",
     "Erdstrom: tonig, nass, langsam bis mäßig schnell; eine Bingham-Flüssigkeit auf ihrer Sohle.",
     "Coulée de terre\u202F: argileuse, humide, lente à modérée\u202F; un fluide de Bingham sur son lit.",
     "Flujo de tierra: arcilloso, húmedo, lento a moderado; un fluido de Bingham sobre su lecho."},
    {"Source: yield stress from Nereson 2015 (AGU Fall Meeting, EP41C-0943), from the levees of earthflows. That "
     "abstract (read) gives 10 to 100 kPa; 30 kPa is about the geometric mean.",
     "Fonte: tensione di soglia da Nereson 2015 (AGU Fall Meeting, EP41C-0943), dagli argini laterali di colate di "
     "terra. Quel riassunto (letto) dà da 10 a 100 kPa; 30 kPa è circa la media geometrica.",
     "Quelle: Fließgrenze nach Nereson 2015 (AGU Fall Meeting, EP41C-0943), aus den seitlichen Wällen von Erdströmen. "
     "Diese Zusammenfassung (gelesen) gibt 10 bis 100 kPa an; 30 kPa ist etwa das geometrische Mittel.",
     "Source\u202F: seuil d’écoulement selon Nereson 2015 (AGU Fall Meeting, EP41C-0943), d’après les levées latérales "
     "de coulées de terre. Ce résumé (lu) donne 10 à 100 kPa\u202F; 30 kPa est à peu près la moyenne géométrique.",
     "Fuente: tensión de fluencia según Nereson 2015 (AGU Fall Meeting, EP41C-0943), de los diques laterales de flujos "
     "de tierra. Ese resumen (leído) da de 10 a 100 kPa; 30 kPa es aproximadamente la media geométrica."},
    {"Density: the sample of MassMov2D (Begueria et al. 2009, Nat. Hazards Earth Syst. Sci. 9, 1897), fine-grained "
     "flows.",
     "Densità: l’esempio di MassMov2D (Begueria et al. 2009, Nat. Hazards Earth Syst. Sci. 9, 1897), colate a grana "
     "fine.",
     "Dichte: das Beispiel von MassMov2D (Begueria et al. 2009, Nat. Hazards Earth Syst. Sci. 9, 1897), feinkörnige "
     "Ströme.",
     "Masse volumique\u202F: l’exemple de MassMov2D (Begueria et al. 2009, Nat. Hazards Earth Syst. Sci. 9, 1897), "
     "écoulements à grains fins.",
     "Densidad: el ejemplo de MassMov2D (Begueria et al. 2009, Nat. Hazards Earth Syst. Sci. 9, 1897), flujos de grano "
     "fino."},
    {"Viscosity: give your own (material.viscosity). No source was found; it varies by orders of magnitude from rapid "
     "to slow earthflows and determines the speed. Fit it to a known speed.",
     "Viscosità: indicarne una propria (material.viscosity). Non è stata trovata alcuna fonte; varia di ordini di "
     "grandezza fra colate di terra rapide e lente e determina la velocità. Adattarla a una velocità nota.",
     "Viskosität: eine eigene angeben (material.viscosity). Es fand sich keine Quelle; sie variiert um Größenordnungen "
     "zwischen schnellen und langsamen Erdströmen und bestimmt die Geschwindigkeit. An eine bekannte Geschwindigkeit "
     "anpassen.",
     "Viscosité\u202F: indiquer la sienne (material.viscosity). Aucune source n’a été trouvée\u202F; elle varie de "
     "plusieurs ordres de grandeur entre coulées de terre rapides et lentes et détermine la vitesse. L’ajuster à une "
     "vitesse connue.",
     "Viscosidad: indique la suya (material.viscosity). No se encontró ninguna fuente; varía en órdenes de magnitud "
     "entre flujos de tierra rápidos y lentos y determina la velocidad. Ajústela a una velocidad conocida."},
    {"Range: yield stress 10 to 100 kPa. It moves only where it is thicker than yield stress / (density g sin(slope)): "
     "3 m on 30 degrees.",
     "Campo di validità: tensione di soglia da 10 a 100 kPa. Si muove solo dove è più spessa di tensione di soglia / "
     "(densità g sin(pendenza)): 3 m su 30 gradi.",
     "Gültigkeit: Fließgrenze 10 bis 100 kPa. Er bewegt sich nur, wo er dicker ist als Fließgrenze / (Dichte g "
     "sin(Neigung)): 3 m bei 30 Grad.",
     "Domaine\u202F: seuil d’écoulement de 10 à 100 kPa. Elle ne se meut que là où elle est plus épaisse que seuil / "
     "(masse volumique g sin(pente))\u202F: 3 m sur 30 degrés.",
     "Validez: tensión de fluencia de 10 a 100 kPa. Solo se mueve donde es más grueso que tensión de fluencia / "
     "(densidad g sin(pendiente)): 3 m en 30 grados."},
    {"Lahar: water-rich volcanic debris flow in a valley; quadratic rheology at the bed.",
     "Lahar: colata detritica vulcanica ricca d’acqua in una valle; reologia quadratica al fondo.",
     "Lahar: wasserreicher vulkanischer Murgang in einem Tal; quadratische Rheologie an der Sohle.",
     "Lahar\u202F: lave torrentielle volcanique riche en eau dans une vallée\u202F; rhéologie quadratique au lit.",
     "Lahar: flujo de detritos volcánico rico en agua en un valle; reología cuadrática en el lecho."},
    {"Source: lahar example of the program IMEX_SfloW2D-LAHARS (de' Michieli Vitturi, INGV; read in its input file), "
     "which uses the law of O'Brien, Julien and Fullerton 1993 (J. Hydraul. Eng. 119, 244) with sediment of 2000 "
     "kg/m3, yield stress 0.0181 exp(25.7 C) Pa, viscosity 0.0036 exp(22.1 C) Pa s, K = 24 and n = 0.1 s/m^(1/3). C, "
     "the volume fraction of sediment, is 0.3 here: that choice is ours, and all values depend on it.",
     "Fonte: esempio di lahar del programma IMEX_SfloW2D-LAHARS (de’ Michieli Vitturi, INGV; letto nel suo file di "
     "ingresso), che usa la legge di O’Brien, Julien e Fullerton 1993 (J. Hydraul. Eng. 119, 244) con sedimento di "
     "2000 kg/m³, tensione di soglia 0,0181 exp(25,7 C) Pa, viscosità 0,0036 exp(22,1 C) Pa s, K = 24 e n = 0,1 "
     "s/m^(1/3). C, la frazione in volume di sedimento, è qui 0,3: la scelta è nostra e tutti i valori ne dipendono.",
     "Quelle: Lahar-Beispiel des Programms IMEX_SfloW2D-LAHARS (de' Michieli Vitturi, INGV; in dessen Eingabedatei "
     "gelesen), das das Gesetz von O'Brien, Julien und Fullerton 1993 (J. Hydraul. Eng. 119, 244) benutzt, mit "
     "Sediment von 2000 kg/m³, Fließgrenze 0,0181 exp(25,7 C) Pa, Viskosität 0,0036 exp(22,1 C) Pa s, K = 24 und n = "
     "0,1 s/m^(1/3). C, der Volumenanteil des Sediments, ist hier 0,3: diese Wahl ist unsere, und alle Werte hängen "
     "von ihr ab.",
     "Source\u202F: exemple de lahar du programme IMEX_SfloW2D-LAHARS (de’ Michieli Vitturi, INGV\u202F; lu dans son "
     "fichier d’entrée), qui utilise la loi d’O’Brien, Julien et Fullerton 1993 (J. Hydraul. Eng. 119, 244) avec un "
     "sédiment de 2000 kg/m³, un seuil de 0,0181 exp(25,7 C) Pa, une viscosité de 0,0036 exp(22,1 C) Pa s, K = 24 et n "
     "= 0,1 s/m^(1/3). C, la fraction volumique de sédiment, vaut ici 0,3\u202F: ce choix est le nôtre, et toutes les "
     "valeurs en dépendent.",
     "Fuente: ejemplo de lahar del programa IMEX_SfloW2D-LAHARS (de' Michieli Vitturi, INGV; leído en su archivo de "
     "entrada), que usa la ley de O'Brien, Julien y Fullerton 1993 (J. Hydraul. Eng. 119, 244) con sedimento de 2000 "
     "kg/m³, tensión de fluencia 0,0181 exp(25,7 C) Pa, viscosidad 0,0036 exp(22,1 C) Pa s, K = 24 y n = 0,1 "
     "s/m^(1/3). C, la fracción en volumen de sedimento, es aquí 0,3: esa elección es nuestra y todos los valores "
     "dependen de ella."},
    {"Range: C = 0.2 to 0.4 gives yield stress 3 to 530 Pa, viscosity 0.3 to 25 Pa s, density 1200 to 1400 kg/m3. On "
     "irregular ground the source of the law has K far above 24. The volume commonly grows with distance: see "
     "[entrainment].",
     "Campo di validità: C = 0,2-0,4 dà tensione di soglia da 3 a 530 Pa, viscosità da 0,3 a 25 Pa s, densità da 1200 "
     "a 1400 kg/m³. Su terreno irregolare la fonte della legge ha K molto oltre 24. Il volume di solito cresce con la "
     "distanza: vedi [entrainment].",
     "Gültigkeit: C = 0,2 bis 0,4 ergibt Fließgrenzen von 3 bis 530 Pa, Viskositäten von 0,3 bis 25 Pa s, Dichten von "
     "1200 bis 1400 kg/m³. Auf unregelmäßigem Gelände hat die Quelle des Gesetzes K weit über 24. Das Volumen wächst "
     "meist mit der Strecke: siehe [entrainment].",
     "Domaine\u202F: C = 0,2 à 0,4 donne un seuil de 3 à 530 Pa, une viscosité de 0,3 à 25 Pa s, une masse volumique "
     "de 1200 à 1400 kg/m³. Sur terrain irrégulier, la source de la loi a K bien au-dessus de 24. Le volume croît "
     "souvent avec la distance\u202F: voir [entrainment].",
     "Validez: C = 0,2 a 0,4 da tensión de fluencia de 3 a 530 Pa, viscosidad de 0,3 a 25 Pa s, densidad de 1200 a "
     "1400 kg/m³. En terreno irregular la fuente de la ley tiene K muy por encima de 24. El volumen suele crecer con "
     "la distancia: véase [entrainment]."},
    {"Mudflow: fine, wet material that runs on gentle slopes; quadratic rheology at the bed.",
     "Colata di fango: materiale fine e umido che scorre su pendenze dolci; reologia quadratica al fondo.",
     "Schlammstrom: feines, nasses Material, das auf flachen Hängen fließt; quadratische Rheologie an der Sohle.",
     "Coulée de boue\u202F: matériau fin et humide qui s’écoule sur des pentes douces\u202F; rhéologie quadratique au "
     "lit.",
     "Flujo de lodo: material fino y húmedo que corre por pendientes suaves; reología cuadrática en el lecho."},
    {"Source: yield stress and viscosity are the starting values of the open program DebrisFrame (OpenNHM, "
     "c1TIFCfg.ini; read there, marked as untested): 0.2511 exp(16.7 C) Pa and 0.14 exp(12.96 C) Pa s at a volume "
     "fraction of sediment C = 0.4, of 2650 kg/m3, which gives the density. Law: O'Brien and Julien 1988 (J. Hydraul. "
     "Eng. 114, 877), in whose abstract both grow by three orders of magnitude between C = 0.1 and 0.4. K = 24, a "
     "smooth wide channel, and n = 0.1 s/m^(1/3) as in the lahar example of IMEX_SfloW2D-LAHARS.",
     "Fonte: tensione di soglia e viscosità sono i valori iniziali del programma aperto DebrisFrame (OpenNHM, "
     "c1TIFCfg.ini; letti lì, indicati come non verificati): 0,2511 exp(16,7 C) Pa e 0,14 exp(12,96 C) Pa s per una "
     "frazione in volume di sedimento C = 0,4, di 2650 kg/m³, che dà la densità. Legge: O’Brien e Julien 1988 (J. "
     "Hydraul. Eng. 114, 877), nel cui riassunto entrambe crescono di tre ordini di grandezza fra C = 0,1 e 0,4. K = "
     "24, un canale liscio e largo, e n = 0,1 s/m^(1/3) come nell’esempio di lahar di IMEX_SfloW2D-LAHARS.",
     "Quelle: Fließgrenze und Viskosität sind die Startwerte des offenen Programms DebrisFrame (OpenNHM, c1TIFCfg.ini; "
     "dort gelesen, als ungeprüft bezeichnet): 0,2511 exp(16,7 C) Pa und 0,14 exp(12,96 C) Pa s bei einem "
     "Volumenanteil des Sediments C = 0,4, von 2650 kg/m³, woraus die Dichte folgt. Gesetz: O'Brien und Julien 1988 "
     "(J. Hydraul. Eng. 114, 877), in deren Zusammenfassung beide zwischen C = 0,1 und 0,4 um drei Größenordnungen "
     "wachsen. K = 24, ein glattes breites Gerinne, und n = 0,1 s/m^(1/3) wie im Lahar-Beispiel von "
     "IMEX_SfloW2D-LAHARS.",
     "Source\u202F: seuil d’écoulement et viscosité sont les valeurs de départ du programme libre DebrisFrame "
     "(OpenNHM, c1TIFCfg.ini\u202F; lues dans celui-ci, indiquées comme non vérifiées)\u202F: 0,2511 exp(16,7 C) Pa et "
     "0,14 exp(12,96 C) Pa s pour une fraction volumique de sédiment C = 0,4, de 2650 kg/m³, ce qui donne la masse "
     "volumique. Loi\u202F: O’Brien et Julien 1988 (J. Hydraul. Eng. 114, 877), dont le résumé indique que toutes deux "
     "croissent de trois ordres de grandeur entre C = 0,1 et 0,4. K = 24, un chenal lisse et large, et n = 0,1 "
     "s/m^(1/3) comme dans l’exemple de lahar d’IMEX_SfloW2D-LAHARS.",
     "Fuente: tensión de fluencia y viscosidad son los valores de partida del programa abierto DebrisFrame (OpenNHM, "
     "c1TIFCfg.ini; leídos en él, indicados como no comprobados): 0,2511 exp(16,7 C) Pa y 0,14 exp(12,96 C) Pa s para "
     "una fracción en volumen de sedimento C = 0,4, de 2650 kg/m³, que da la densidad. Ley: O'Brien y Julien 1988 (J. "
     "Hydraul. Eng. 114, 877), en cuyo resumen ambas crecen tres órdenes de magnitud entre C = 0,1 y 0,4. K = 24, un "
     "cauce liso y ancho, y n = 0,1 s/m^(1/3) como en el ejemplo de lahar de IMEX_SfloW2D-LAHARS."},
    {"Range: C = 0.3 to 0.5 gives yield stress 38 to 1060 Pa, viscosity 7 to 91 Pa s, density 1500 to 1830 kg/m3; "
     "measure them where you can. FLO-2D's documentation lists K from 24 on concrete to 50000 on grass, 2285 for a "
     "residential area. For comparison: the sample of MassMov2D (Begueria et al. 2009, Nat. Hazards Earth Syst. Sci. "
     "9, 1897) has 50 Pa, 100 Pa s and 1850 kg/m3.",
     "Campo di validità: C = 0,3-0,5 dà tensione di soglia da 38 a 1060 Pa, viscosità da 7 a 91 Pa s, densità da 1500 "
     "a 1830 kg/m³; misurarle dove si può. La documentazione di FLO-2D elenca K da 24 su calcestruzzo a 50000 su erba, "
     "2285 per un’area residenziale. Per confronto: l’esempio di MassMov2D (Begueria et al. 2009, Nat. Hazards Earth "
     "Syst. Sci. 9, 1897) ha 50 Pa, 100 Pa s e 1850 kg/m³.",
     "Gültigkeit: C = 0,3 bis 0,5 ergibt Fließgrenzen von 38 bis 1060 Pa, Viskositäten von 7 bis 91 Pa s, Dichten von "
     "1500 bis 1830 kg/m³; wo möglich messen. Die Dokumentation von FLO-2D nennt K von 24 auf Beton bis 50000 auf "
     "Gras, 2285 für ein Wohngebiet. Zum Vergleich: das Beispiel von MassMov2D (Begueria et al. 2009, Nat. Hazards "
     "Earth Syst. Sci. 9, 1897) hat 50 Pa, 100 Pa s und 1850 kg/m³.",
     "Domaine\u202F: C = 0,3 à 0,5 donne un seuil de 38 à 1060 Pa, une viscosité de 7 à 91 Pa s, une masse volumique "
     "de 1500 à 1830 kg/m³\u202F; les mesurer là où c’est possible. La documentation de FLO-2D donne K de 24 sur béton "
     "à 50000 sur herbe, 2285 pour une zone résidentielle. Pour comparaison\u202F: l’exemple de MassMov2D (Begueria et "
     "al. 2009, Nat. Hazards Earth Syst. Sci. 9, 1897) a 50 Pa, 100 Pa s et 1850 kg/m³.",
     "Validez: C = 0,3 a 0,5 da tensión de fluencia de 38 a 1060 Pa, viscosidad de 7 a 91 Pa s, densidad de 1500 a "
     "1830 kg/m³; mídalas donde sea posible. La documentación de FLO-2D da K de 24 en hormigón a 50000 en hierba, 2285 "
     "para una zona residencial. Para comparar: el ejemplo de MassMov2D (Begueria et al. 2009, Nat. Hazards Earth "
     "Syst. Sci. 9, 1897) tiene 50 Pa, 100 Pa s y 1850 kg/m³."},
    {"Rock avalanche: fragmented rock, large volumes (over a million m3).",
     "Valanga di roccia: roccia frammentata, grandi volumi (oltre un milione di m³).",
     "Sturzstrom aus Fels: zerbrochener Fels, große Volumen (über eine Million m³).",
     "Avalanche rocheuse\u202F: roche fragmentée, grands volumes (plus d’un million de m³).",
     "Avalancha de rocas: roca fragmentada, grandes volúmenes (más de un millón de m³)."},
    {"Source: friction coefficient 0.1 and turbulence 500 m/s2 are quoted from Hungr and Evans 1996 (back-analysis of "
     "23 rock avalanches). Their paper was not at hand: take the values as customary, not as confirmed. Starting "
     "values of two programs, read in their files: friction coefficient 0.035, turbulence 700 m/s2, density 2500 kg/m3 "
     "(AvaFrame, com6RockAvalanche, marked as untested); 0.2 and 500 m/s2 with another form of the law, where friction "
     "ends at 4 m/s (MinVoellmy in TopoToolbox; Hergarten 2024, Geosci. Model Dev. 17, 781).",
     "Fonte: coefficiente di attrito 0,1 e turbolenza 500 m/s² sono citati da Hungr ed Evans 1996 (analisi a ritroso "
     "di 23 valanghe di roccia). Il loro articolo non era a disposizione: i valori valgono come consueti, non come "
     "confermati. Valori iniziali di due programmi, letti nei loro file: coefficiente di attrito 0,035, turbolenza 700 "
     "m/s², densità 2500 kg/m³ (AvaFrame, com6RockAvalanche, indicati come non verificati); 0,2 e 500 m/s² con "
     "un’altra forma della legge, dove l’attrito cessa a 4 m/s (MinVoellmy in TopoToolbox; Hergarten 2024, Geosci. "
     "Model Dev. 17, 781).",
     "Quelle: Reibungsbeiwert 0,1 und Turbulenz 500 m/s² sind nach Hungr und Evans 1996 zitiert (Rückrechnung von 23 "
     "Sturzströmen). Ihr Aufsatz lag nicht vor: die Werte gelten als üblich, nicht als bestätigt. Startwerte zweier "
     "Programme, in deren Dateien gelesen: Reibungsbeiwert 0,035, Turbulenz 700 m/s², Dichte 2500 kg/m³ (AvaFrame, "
     "com6RockAvalanche, als ungeprüft bezeichnet); 0,2 und 500 m/s² mit einer anderen Form des Gesetzes, in der die "
     "Reibung bei 4 m/s endet (MinVoellmy in TopoToolbox; Hergarten 2024, Geosci. Model Dev. 17, 781).",
     "Source\u202F: coefficient de frottement 0,1 et turbulence 500 m/s² sont cités d’après Hungr et Evans 1996 "
     "(rétro-analyse de 23 avalanches rocheuses). Leur article n’était pas disponible\u202F: prendre ces valeurs comme "
     "usuelles, non comme confirmées. Valeurs de départ de deux programmes, lues dans leurs fichiers\u202F: "
     "coefficient de frottement 0,035, turbulence 700 m/s², masse volumique 2500 kg/m³ (AvaFrame, com6RockAvalanche, "
     "indiquées comme non vérifiées)\u202F; 0,2 et 500 m/s² avec une autre forme de la loi, où le frottement cesse à 4 "
     "m/s (MinVoellmy dans TopoToolbox\u202F; Hergarten 2024, Geosci. Model Dev. 17, 781).",
     "Fuente: coeficiente de fricción 0,1 y turbulencia 500 m/s² se citan de Hungr y Evans 1996 (retroanálisis de 23 "
     "avalanchas de rocas). Su artículo no estaba disponible: los valores valen como habituales, no como confirmados. "
     "Valores de partida de dos programas, leídos en sus archivos: coeficiente de fricción 0,035, turbulencia 700 "
     "m/s², densidad 2500 kg/m³ (AvaFrame, com6RockAvalanche, indicados como no comprobados); 0,2 y 500 m/s² con otra "
     "forma de la ley, en la que la fricción acaba a 4 m/s (MinVoellmy en TopoToolbox; Hergarten 2024, Geosci. Model "
     "Dev. 17, 781)."},
    {"Density: the first of the two. With these laws it changes the pressure, not the motion.",
     "Densità: la prima delle due. Con queste leggi cambia la pressione, non il moto.",
     "Dichte: die erste der beiden. Mit diesen Gesetzen ändert sie den Druck, nicht die Bewegung.",
     "Masse volumique\u202F: la première des deux. Avec ces lois elle change la pression, non le mouvement.",
     "Densidad: la primera de las dos. Con estas leyes cambia la presión, no el movimiento."},
    {"Range: friction coefficient 0.035 to 0.2, turbulence 500 to 700 m/s2 between the three; small dry rock falls "
     "have higher friction.",
     "Campo di validità: coefficiente di attrito da 0,035 a 0,2, turbolenza da 500 a 700 m/s² fra le tre fonti; i "
     "piccoli crolli di roccia asciutti hanno attrito maggiore.",
     "Gültigkeit: Reibungsbeiwert 0,035 bis 0,2, Turbulenz 500 bis 700 m/s² zwischen den dreien; kleine trockene "
     "Felsstürze haben höhere Reibung.",
     "Domaine\u202F: coefficient de frottement de 0,035 à 0,2, turbulence de 500 à 700 m/s² entre les trois\u202F; les "
     "petits éboulements secs ont un frottement plus élevé.",
     "Validez: coeficiente de fricción de 0,035 a 0,2, turbulencia de 500 a 700 m/s² entre las tres; los pequeños "
     "desprendimientos secos tienen mayor fricción."},
    {"Large dense-flow snow avalanche.", "Grande valanga di neve radente densa.", "Große Fließlawine aus Schnee.",
     "Grande avalanche de neige dense.", "Gran avalancha de nieve densa."},
    {"Source: Martinelli, Lang and Mears 1980 (Journal of Glaciology 26, 94), large design avalanches. Its abstract "
     "(read) gives friction 0.15 and turbulence 1200 to 1600 m/s2; the mean is used.",
     "Fonte: Martinelli, Lang e Mears 1980 (Journal of Glaciology 26, 94), grandi valanghe di progetto. Il riassunto "
     "(letto) dà attrito 0,15 e turbolenza da 1200 a 1600 m/s²; si usa la media.",
     "Quelle: Martinelli, Lang und Mears 1980 (Journal of Glaciology 26, 94), große Bemessungslawinen. Die "
     "Zusammenfassung (gelesen) gibt Reibung 0,15 und Turbulenz 1200 bis 1600 m/s² an; benutzt ist das Mittel.",
     "Source\u202F: Martinelli, Lang et Mears 1980 (Journal of Glaciology 26, 94), grandes avalanches de projet. Le "
     "résumé (lu) donne un frottement de 0,15 et une turbulence de 1200 à 1600 m/s²\u202F; la moyenne est utilisée.",
     "Fuente: Martinelli, Lang y Mears 1980 (Journal of Glaciology 26, 94), grandes avalanchas de proyecto. El resumen "
     "(leído) da fricción 0,15 y turbulencia de 1200 a 1600 m/s²; se usa la media."},
    {"Density: flow density in the template of the program MoT-Voellmy (Norwegian Geotechnical Institute; read in its "
     "notes on use; deposits 450 kg/m3 there). With this law it changes the pressure, not the motion.",
     "Densità: densità di flusso nel modello di esempio del programma MoT-Voellmy (Norwegian Geotechnical Institute; "
     "letta nelle sue note d’uso; depositi 450 kg/m³). Con questa legge cambia la pressione, non il moto.",
     "Dichte: Fließdichte in der Vorlage des Programms MoT-Voellmy (Norwegian Geotechnical Institute; in dessen "
     "Hinweisen gelesen; Ablagerungen dort 450 kg/m³). Mit diesem Gesetz ändert sie den Druck, nicht die Bewegung.",
     "Masse volumique\u202F: celle de l’écoulement dans le fichier type du programme MoT-Voellmy (Norwegian "
     "Geotechnical Institute\u202F; lue dans sa notice\u202F; dépôts 450 kg/m³). Avec cette loi elle change la "
     "pression, non le mouvement.",
     "Densidad: densidad del flujo en la plantilla del programa MoT-Voellmy (Norwegian Geotechnical Institute; leída "
     "en sus notas de uso; depósitos 450 kg/m³). Con esta ley cambia la presión, no el movimiento."},
    {"Range: slow wet or hard-slab avalanches in the same abstract: turbulence 700 to 800 m/s2, friction 5 / speed "
     "[m/s]. Ten extreme avalanches in Buser and Frutiger 1980 (Journal of Glaciology 26, 94; abstract read): friction "
     "0.155, turbulence 1120 m/s2. Density 200 kg/m3 in AvaFrame's com1DFA (its settings, read).",
     "Campo di validità: valanghe lente di neve umida o di lastroni duri nello stesso riassunto: turbolenza da 700 a "
     "800 m/s², attrito 5 / velocità [m/s]. Dieci valanghe estreme in Buser e Frutiger 1980 (Journal of Glaciology 26, "
     "94; letto il riassunto): attrito 0,155, turbolenza 1120 m/s². Densità 200 kg/m³ in com1DFA di AvaFrame (lette le "
     "impostazioni).",
     "Gültigkeit: langsame Nassschnee- oder harte Schneebrettlawinen in derselben Zusammenfassung: Turbulenz 700 bis "
     "800 m/s², Reibung 5 / Geschwindigkeit [m/s]. Zehn extreme Lawinen in Buser und Frutiger 1980 (Journal of "
     "Glaciology 26, 94; Zusammenfassung gelesen): Reibung 0,155, Turbulenz 1120 m/s². Dichte 200 kg/m³ in com1DFA von "
     "AvaFrame (Einstellungen gelesen).",
     "Domaine\u202F: avalanches lentes de neige humide ou de plaque dure dans le même résumé\u202F: turbulence de 700 "
     "à 800 m/s², frottement 5 / vitesse [m/s]. Dix avalanches extrêmes dans Buser et Frutiger 1980 (Journal of "
     "Glaciology 26, 94\u202F; résumé lu)\u202F: frottement 0,155, turbulence 1120 m/s². Masse volumique de 200 kg/m³ "
     "dans com1DFA d’AvaFrame (réglages lus).",
     "Validez: avalanchas lentas de nieve húmeda o de placa dura en el mismo resumen: turbulencia de 700 a 800 m/s², "
     "fricción 5 / velocidad [m/s]. Diez avalanchas extremas en Buser y Frutiger 1980 (Journal of Glaciology 26, 94; "
     "resumen leído): fricción 0,155, turbulencia 1120 m/s². Densidad 200 kg/m³ en com1DFA de AvaFrame (ajustes "
     "leídos)."},
    {"Hard-slab snow avalanche.", "Valanga di neve a lastroni duri.", "Lawine aus hartem Schneebrett.",
     "Avalanche de neige de plaque dure.", "Avalancha de nieve de placa dura."},
    {"Source: Martinelli, Lang and Mears 1980 (Journal of Glaciology 26, 94). Its abstract (read) gives the sliding "
     "friction of a hard-slab avalanche measured from films, 0.35, 0.43 and 0.32 on three sections, and a turbulence "
     "of 700 to 800 m/s2 (with a friction of 5 / speed [m/s]); the mean is used.",
     "Fonte: Martinelli, Lang e Mears 1980 (Journal of Glaciology 26, 94). Il riassunto (letto) dà l’attrito di una "
     "valanga di lastroni duri misurato da filmati, 0,35, 0,43 e 0,32 su tre tratti, e una turbolenza da 700 a 800 "
     "m/s² (con attrito 5 / velocità [m/s]); si usa la media.",
     "Quelle: Martinelli, Lang und Mears 1980 (Journal of Glaciology 26, 94). Die Zusammenfassung (gelesen) gibt die "
     "Gleitreibung einer harten Schneebrettlawine nach Filmen an, 0,35, 0,43 und 0,32 auf drei Abschnitten, und eine "
     "Turbulenz von 700 bis 800 m/s² (mit einer Reibung von 5 / Geschwindigkeit [m/s]); benutzt ist das Mittel.",
     "Source\u202F: Martinelli, Lang et Mears 1980 (Journal of Glaciology 26, 94). Le résumé (lu) donne le frottement "
     "d’une avalanche de plaque dure mesuré sur des films, 0,35, 0,43 et 0,32 sur trois tronçons, et une turbulence de "
     "700 à 800 m/s² (avec un frottement de 5 / vitesse [m/s])\u202F; la moyenne est utilisée.",
     "Fuente: Martinelli, Lang y Mears 1980 (Journal of Glaciology 26, 94). El resumen (leído) da la fricción de una "
     "avalancha de placa dura medida en películas, 0,35, 0,43 y 0,32 en tres tramos, y una turbulencia de 700 a 800 "
     "m/s² (con una fricción de 5 / velocidad [m/s]); se usa la media."},
    {"Range: friction coefficient 0.32 to 0.43, turbulence 700 to 800 m/s2 in that abstract. Density 200 kg/m3 in "
     "AvaFrame's com1DFA (its settings, read).",
     "Campo di validità: coefficiente di attrito da 0,32 a 0,43, turbolenza da 700 a 800 m/s² in quel riassunto. "
     "Densità 200 kg/m³ in com1DFA di AvaFrame (lette le impostazioni).",
     "Gültigkeit: Reibungsbeiwert 0,32 bis 0,43, Turbulenz 700 bis 800 m/s² in dieser Zusammenfassung. Dichte 200 "
     "kg/m³ in com1DFA von AvaFrame (Einstellungen gelesen).",
     "Domaine\u202F: coefficient de frottement de 0,32 à 0,43, turbulence de 700 à 800 m/s² dans ce résumé. Masse "
     "volumique de 200 kg/m³ dans com1DFA d’AvaFrame (réglages lus).",
     "Validez: coeficiente de fricción de 0,32 a 0,43, turbulencia de 700 a 800 m/s² en ese resumen. Densidad 200 "
     "kg/m³ en com1DFA de AvaFrame (ajustes leídos)."},
});

}  // namespace

std::span<const WordRow> preset_words() {
    return k_preset_words;
}

}  // namespace frana
