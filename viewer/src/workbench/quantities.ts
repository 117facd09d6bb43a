/** German of what is computed, by its English words: quantities of the catalogues, channels, parts, and the keys of forms. */

import type { Store } from "../data";
import { isGerman, translate } from "../words";

/** Quantities of the kinematic catalogue, as short as a head: by their names. */
const NAMES: Record<string, string> = {
  wheel_travel: "Radhub",
  rack_travel: "Zahnstangenweg",
  camber: "Sturz",
  inclination: "Radneigung",
  steer: "Lenkwinkel",
  toe: "Spur (Einzelspur)",
  caster: "Nachlaufwinkel",
  kingpin_inclination: "Spreizung",
  caster_trail: "Nachlaufstrecke",
  scrub_radius: "Lenkrollhalbmesser",
  spindle_offset: "Spreizungsversatz Radmitte",
  wheel_centre_caster_offset: "Nachlaufversatz Radmitte",
  caster_trail_wheel: "Nachlaufstrecke, Radachsen",
  scrub_radius_wheel: "Lenkrollhalbmesser, Radachsen",
  spindle_offset_wheel: "Spreizungsversatz Radmitte, Radachsen",
  wheel_centre_caster_offset_wheel: "Nachlaufversatz Radmitte, Radachsen",
  steering_axis_pitch: "Steigung der Lenkachse",
  caster_held_spring: "Nachlaufwinkel, Feder gehalten",
  kingpin_inclination_held_spring: "Spreizung, Feder gehalten",
  caster_trail_held_spring: "Nachlaufstrecke, Feder gehalten",
  scrub_radius_held_spring: "Lenkrollhalbmesser, Feder gehalten",
  wheel_centre_x: "Radmitte x",
  wheel_centre_y: "Radmitte y",
  wheel_centre_z: "Radmitte z",
  contact_point_x: "Radaufstandspunkt x",
  contact_point_y: "Radaufstandspunkt y",
  contact_point_z: "Radaufstandspunkt z",
  half_track_change: "Halbspurweitenänderung",
  half_track_gradient: "Halbspurweitengradient",
  bump_steer: "Spuränderung über Radhub",
  camber_gain: "Sturzänderung über Radhub",
  caster_gain: "Nachlaufänderung über Radhub",
  kingpin_inclination_gain: "Spreizungsänderung über Radhub",
  instant_centre_y: "Querpol y",
  instant_centre_z: "Querpol z",
  side_instant_centre_x: "Längspol x",
  side_instant_centre_z: "Längspol z",
  front_view_swing_arm_length: "Querpolabstand",
  side_view_swing_arm_length: "Längspolabstand",
  front_view_swing_arm_angle: "Querpolstrahlwinkel",
  side_view_swing_arm_angle: "Längspolstrahlwinkel",
  roll_centre_height: "Wankzentrumshöhe",
  jacking: "Aufstützkraft je Seitenkraft",
  contact_patch_recession: "Schrägfederung am Radaufstand",
  wheel_centre_longitudinal_slope: "Radmitte dx/dz",
  wheel_centre_recession: "Schrägfederung der Radmitte",
  wheel_centre_lateral_slope: "Radmitte dy/dz",
  spring_length: "Federlänge",
  damper_length: "Dämpferlänge",
  motion_ratio: "Federübersetzung",
  motion_ratio_contact: "Federübersetzung am Radaufstand",
  motion_ratio_gradient: "Gradient der Federübersetzung",
  motion_ratio_contact_gradient: "Gradient der Federübersetzung am Radaufstand",
  damper_motion_ratio: "Dämpferübersetzung",
  spring_force: "Federkraft",
  stop_force: "Anschlagkraft",
  damper_force: "Dämpferkraft in Ruhe",
  wheel_force: "Federkraft am Rad",
  wheel_rate: "Radfederrate",
  wheel_rate_spring: "Radfederrate ohne Vorspannung",
  wheel_rate_contact: "Radfederrate am Radaufstand",
  wheel_rate_contact_spring: "Radfederrate am Radaufstand ohne Vorspannung",
  wheel_damping_coefficient: "Dämpfungskonstante am Rad",
  tyre_deflection: "Reifeneinfederung",
  tyre_stiffness: "Reifensteifigkeit",
  ride_rate: "Gesamtfederrate mit Reifen",
  anti_roll_bar_angle: "Stabilisatorverdrehung",
  anti_roll_bar_motion_ratio: "Stabilisatorübersetzung",
  anti_roll_bar_motion_ratio_gradient: "Gradient der Stabilisatorübersetzung",
  anti_roll_bar_rate: "Stabilisatorrate am Rad",
  anti_roll_bar_arm_angle: "Winkel Stabilisatorarm–Pendelstütze",
  anti_roll_bar_stiffness: "Stabilisatorsteifigkeit",
  torsion_bar_angle: "Drehstabverdrehung",
  torsion_bar_motion_ratio: "Drehstabübersetzung",
  torsion_bar_torque: "Drehstabmoment",
  third_spring_length: "Länge der dritten Feder",
  third_spring_motion_ratio: "Übersetzung der dritten Feder",
  third_spring_force: "Kraft der dritten Feder",
  third_wheel_force: "Kraft der dritten Feder am Rad",
  third_wheel_rate: "Radfederrate der dritten Feder",
  third_damping_coefficient: "Dämpfungskonstante des dritten Dämpfers",
  heave_force: "Hubkraft am Rad",
  heave_rate: "Hubfederrate am Rad",
  rocker_angle: "Umlenkhebelwinkel",
  pushrod_angle: "Winkel Druckstrebe–Umlenkhebel",
  rocker_spring_angle: "Winkel Feder–Umlenkhebel",
  steer_gain: "Lenkwinkel je Zahnstangenweg",
  camber_per_steer: "Sturzänderung über Lenkeinschlag",
  ride_height_change: "Änderung der Fahrzeughöhe",
  camber_to_ground: "Sturz zur Fahrbahn",
  roll_steer: "Eigenlenken beim Wanken",
  roll_camber: "Sturzänderung über Wankwinkel",
  roll_caster: "Nachlaufänderung über Wankwinkel",
  track: "Spurweite",
  roll_centre_y: "Wankzentrum y",
  roll_moment: "Wankmoment",
  roll_stiffness_springs: "Wanksteifigkeit der Federn",
  roll_stiffness_bar: "Wanksteifigkeit des Stabilisators",
  roll_stiffness: "Wanksteifigkeit",
  roll_stiffness_total: "Wanksteifigkeit mit Reifen",
  roll_angle: "Wankwinkel",
};

/** Places and parts. */
const PARTS: Record<string, string> = {
  arm: "Lenker",
  "arm inner": "Lenker innen",
  "arm outer": "Lenker außen",
  body: "Aufbau",
  "contact point": "Radaufstandspunkt",
  "damper bottom": "Dämpfer unten",
  "damper top": "Dämpfer oben",
  "link 1": "Lenker 1",
  "link 1 inner": "Lenker 1 innen",
  "link 1 outer": "Lenker 1 außen",
  "link 2": "Lenker 2",
  "link 2 inner": "Lenker 2 innen",
  "link 2 outer": "Lenker 2 außen",
  "link 3": "Lenker 3",
  "link 3 inner": "Lenker 3 innen",
  "link 3 outer": "Lenker 3 außen",
  "link 4": "Lenker 4",
  "link 4 inner": "Lenker 4 innen",
  "link 4 outer": "Lenker 4 außen",
  "link 5": "Lenker 5",
  "link 5 inner": "Lenker 5 innen",
  "link 5 outer": "Lenker 5 außen",
  "push rod": "Druckstrebe",
  "lower arm": "unterer Querlenker",
  "lower arm front": "unterer Querlenker vorn",
  "lower arm rear": "unterer Querlenker hinten",
  "lower ball joint": "unteres Traggelenk",
  "lower joint": "unteres Gelenk",
  pushrod: "Druckstrebe",
  "pushrod inner": "Druckstrebe innen",
  "pushrod outer": "Druckstrebe außen",
  rack: "Zahnstange",
  rocker: "Umlenkhebel",
  "rocker axis": "Umlenkhebelachse",
  "rocker pivot": "Umlenkhebellager",
  sprung: "gefederte Masse",
  unsprung: "ungefederte Masse",
  strut: "Federbein",
  "strut bottom": "Federbein unten",
  "strut slider": "Federbeinführung",
  "strut top": "Federbein oben",
  "spring bottom": "Feder unten",
  "spring top": "Feder oben",
  "third spring end": "Ende der dritten Feder",
  "arb axis": "Stabilisatorachse",
  "arb arm end": "Ende des Stabilisatorarms",
  "arb link end": "Ende der Pendelstütze",
  "arb pivot": "Stabilisatorlager",
  "tie rod": "Spurstange",
  "tie rod inner": "Spurstange innen",
  "tie rod outer": "Spurstange außen",
  "upper arm": "oberer Querlenker",
  "upper arm front": "oberer Querlenker vorn",
  "upper arm rear": "oberer Querlenker hinten",
  "upper ball joint": "oberes Traggelenk",
  "upper joint": "oberes Gelenk",
  upright: "Radträger",
  wheel: "Rad",
  "wheel centre": "Radmitte",
  left: "links",
  right: "rechts",
  front: "vorn",
  rear: "hinten",
  "front left": "vorn links",
  "front right": "vorn rechts",
  "rear left": "hinten links",
  "rear right": "hinten rechts",
};

/** Keys of a description, as its form names them. */
const KEYS: Record<string, string> = {
  angle: "Winkel",
  "anti roll bar": "Stabilisator",
  "anti roll bar rate": "Stabilisatorrate",
  blade: "Blatt",
  bodies: "Körper",
  body: "Aufbau",
  "bump coefficient": "Druckstufe",
  "bump stop": "Druckanschlag",
  bushings: "Gummilager",
  camber: "Sturz",
  "centre of mass": "Schwerpunkt",
  coefficient: "Konstante",
  coefficients: "Koeffizienten",
  column: "Lenksäule",
  compat: "Kompatibilität",
  corner: "Ecke",
  curve: "Kennlinie",
  damper: "Dämpfer",
  damping: "Dämpfung",
  "damping coefficient": "Dämpfungskonstante",
  deflection: "Einfederung",
  "displacement coupling": "Wegkopplung",
  distance: "Abstand",
  estimated: "geschätzt",
  exponent: "Exponent",
  force: "Kraft",
  "free length": "ungespannte Länge",
  friction: "Reibung",
  gap: "Spiel",
  gravity: "Erdbeschleunigung",
  guide: "Führung",
  "guide friction": "Führungsreibung",
  handwheel: "Lenkrad",
  hardpoints: "Kinematikpunkte",
  height: "Höhe",
  "hysteretic force": "Hysteresekraft",
  inertia: "Trägheit",
  joint: "Gelenk",
  kind: "Art",
  law: "Gesetz",
  length: "Länge",
  "lift off": "Abheben",
  mass: "Masse",
  model: "Modell",
  offset: "Versatz",
  on: "an",
  phase: "Phase",
  pinion: "Ritzel",
  "pitch inertia": "Nickträgheit",
  preload: "Vorspannung",
  presliding: "Vorgleitanteil",
  "presliding distance": "Vorgleitweg",
  progression: "Progression",
  "pushrod on": "Druckstrebe an",
  "rack ratio": "Zahnstangenübersetzung",
  "rack travel": "Zahnstangenweg",
  radius: "Halbmesser",
  rate: "Rate",
  "rebound coefficient": "Zugstufe",
  "rebound stop": "Zuganschlag",
  "regularisation velocity": "Regularisierungsgeschwindigkeit",
  "roll centre height": "Wankzentrumshöhe",
  "roll inertia": "Wankträgheit",
  "rotational stiffness": "Drehsteifigkeit",
  schema: "Schema",
  side: "Seite",
  sigma: "Sigma",
  slope: "Steigung",
  source: "Quelle",
  spring: "Feder",
  "spring rate": "Federrate",
  sprung: "gefederte Masse",
  steering: "Lenkung",
  stiffness: "Steifigkeit",
  strut: "Federbein",
  thickness: "Dicke",
  "third spring": "dritte Feder",
  toe: "Spur",
  "torsion bar": "Drehstab",
  track: "Spurweite",
  tyre: "Reifen",
  "undeformed radius": "unverformter Halbmesser",
  unsprung: "ungefederte Masse",
  "unsprung mass": "ungefederte Masse",
  velocity: "Geschwindigkeit",
  width: "Breite",
  without: "ohne",
  xx: "xx",
  xy: "xy",
  xz: "xz",
  "yoke angle": "Gabelwinkel",
  "youngs modulus": "E-Modul",
  yy: "yy",
  yz: "yz",
  zz: "zz",
  "linear damper": "linearer Dämpfer",
  "bilinear damper": "Dämpfer mit Druck- und Zugstufe",
  "blow off damper": "degressiver Dämpfer mit Überdruckventil",
  "map damper": "Dämpfer mit Kennfeld",
  "tanh damper": "Tanh-Dämpfer",
  "bouc wen damper": "Bouc-Wen-Dämpfer",
  "velocity table": "Tabelle über der Geschwindigkeit",
  "polynomial curve": "Polynom",
  "power curve": "Potenzgesetz",
  "table curve": "Tabelle",
  "coil spring": "Schraubenfeder",
  "rigid body": "starrer Körper",
  lump: "Punktmasse",
};

/** Channels, quantities and metrics in whole words. */
const WORDS: Record<string, string> = {
  "commanded damping coefficient": "befohlene Dämpfungskonstante",
  "commanded force, compression positive": "befohlene Kraft, Druck positiv",
  "commanded voltage": "befohlene Spannung",
  "force of the actuator, compression positive": "Kraft des Stellers, Druck positiv",
  "vertical travel of the wheel centre": "Hub der Radmitte",
  "travel of the steering rack": "Weg der Zahnstange",
  "camber angle": "Sturzwinkel",
  "inclination angle": "Neigungswinkel des Rades",
  "steer angle": "Lenkwinkel",
  "toe angle": "Spurwinkel",
  "caster angle": "Nachlaufwinkel",
  "kingpin inclination": "Spreizung",
  "caster trail at the ground, vehicle's axes": "Nachlaufstrecke am Boden, Fahrzeugachsen",
  "kingpin offset at the ground, vehicle's axes": "Lenkrollhalbmesser am Boden, Fahrzeugachsen",
  "kingpin offset at the wheel centre, vehicle's axes":
    "Spreizungsversatz in Höhe der Radmitte, Fahrzeugachsen",
  "caster offset at the wheel centre, vehicle's axes":
    "Nachlaufversatz in Höhe der Radmitte, Fahrzeugachsen",
  "caster trail at the ground, wheel's axes (turned by the steer angle)":
    "Nachlaufstrecke am Boden, Radachsen (um den Lenkwinkel gedreht)",
  "kingpin offset at the ground, wheel's axes (turned by the steer angle)":
    "Lenkrollhalbmesser am Boden, Radachsen (um den Lenkwinkel gedreht)",
  "kingpin offset at the wheel centre, wheel's axes (turned by the steer angle)":
    "Spreizungsversatz in Höhe der Radmitte, Radachsen (um den Lenkwinkel gedreht)",
  "caster offset at the wheel centre, wheel's axes (turned by the steer angle)":
    "Nachlaufversatz in Höhe der Radmitte, Radachsen (um den Lenkwinkel gedreht)",
  "motion along the steering axis over the turn about it":
    "Weg entlang der Lenkachse je Drehung um sie",
  "caster angle of the screw that the rack makes at held spring length":
    "Nachlaufwinkel der Schraubung, die die Zahnstange bei gehaltener Federlänge erzeugt",
  "kingpin inclination of the screw that the rack makes at held spring length":
    "Spreizung der Schraubung, die die Zahnstange bei gehaltener Federlänge erzeugt",
  "caster trail, vehicle's axes, of the screw that the rack makes at held spring length":
    "Nachlaufstrecke, Fahrzeugachsen, der Schraubung, die die Zahnstange bei gehaltener Federlänge erzeugt",
  "kingpin offset at the ground, vehicle's axes, of the screw that the rack makes at held spring length":
    "Lenkrollhalbmesser am Boden, Fahrzeugachsen, der Schraubung, die die Zahnstange bei gehaltener Federlänge erzeugt",
  "half-track change: contact point against design":
    "Änderung der halben Spurweite: Radaufstandspunkt gegen Konstruktionslage",
  "half-track gradient": "Änderung der halben Spurweite je Radhub",
  "bump steer": "Spuränderung über Radhub",
  "camber gain": "Sturzänderung über Radhub",
  "caster gain": "Nachlaufänderung über Radhub",
  "front-view instant centre, y": "Querpol, y",
  "front-view instant centre, z": "Querpol, z",
  "side-view instant centre, x": "Längspol, x",
  "side-view instant centre, z": "Längspol, z",
  "front-view swing arm length": "Querpolabstand",
  "side-view swing arm length": "Längspolabstand",
  "front-view swing arm angle to the ground": "Winkel des Querpolstrahls zum Boden",
  "side-view swing arm angle to the ground": "Winkel des Längspolstrahls zum Boden",
  "roll centre height of a symmetric axle": "Wankzentrumshöhe einer symmetrischen Achse",
  "jacking: vertical force on the wheel per outward lateral force":
    "Aufstützen: senkrechte Kraft am Rad je nach außen gerichteter Seitenkraft",
  "contact patch recession: dx/dz with the wheel locked":
    "Schrägfederung am Radaufstand: dx/dz bei blockiertem Rad",
  "wheel centre, dx/dz": "Radmitte, dx/dz",
  "wheel centre recession: its dx over the rise dz of the contact patch":
    "Schrägfederung der Radmitte: ihr dx über dem Anstieg dz des Radaufstands",
  "lateral motion of the wheel centre over its rise": "Querbewegung der Radmitte über ihrem Hub",
  "spring length": "Federlänge",
  "damper length": "Dämpferlänge",
  "motion ratio: spring compression over wheel travel": "Federübersetzung: Federweg über Radhub",
  "motion ratio at the contact patch: spring compression over its rise":
    "Federübersetzung am Radaufstand: Federweg über dessen Hub",
  "motion-ratio gradient": "Änderung der Federübersetzung über Radhub",
  "motion-ratio gradient at the contact patch": "Änderung der Federübersetzung am Radaufstand",
  "damper motion ratio: damper compression over wheel travel":
    "Dämpferübersetzung: Dämpferweg über Radhub",
  "spring force": "Federkraft",
  "force of bump and rebound stops": "Kraft der Druck- und Zuganschläge",
  "force of spring, stops and damper at rest at the wheel centre":
    "Kraft von Feder, Anschlägen und ruhendem Dämpfer an der Radmitte",
  "force of the damper at rest: its gas, and what grows with its stroke":
    "Kraft des ruhenden Dämpfers: sein Gas, und was mit dem Hub wächst",
  "wheel rate at the wheel centre, preload term included":
    "Radfederrate an der Radmitte, mit Vorspannungsanteil",
  "wheel rate without the preload term": "Radfederrate ohne Vorspannungsanteil",
  "wheel rate at the contact patch, preload term included":
    "Radfederrate am Radaufstand, mit Vorspannungsanteil",
  "wheel rate at the contact patch without the preload term":
    "Radfederrate am Radaufstand ohne Vorspannungsanteil",
  "damping coefficient at the wheel centre, about rest":
    "Dämpfungskonstante an der Radmitte, um die Ruhelage",
  "tyre deflection at the wheel's radius": "Reifeneinfederung beim Halbmesser des Rades",
  "stiffness of the tyre at its deflection": "Steifigkeit des Reifens bei seiner Einfederung",
  "ride rate: wheel rate and tyre in series": "Gesamtfederrate: Radfederrate und Reifen in Reihe",
  "rotation of the anti-roll bar's end": "Verdrehung des Stabilisatorendes",
  "anti-roll bar motion ratio: rotation of its end over wheel travel":
    "Stabilisatorübersetzung: Verdrehung seines Endes über Radhub",
  "anti-roll bar motion-ratio gradient": "Änderung der Stabilisatorübersetzung über Radhub",
  "wheel rate of the anti-roll bar in opposite wheel travel":
    "Radfederrate des Stabilisators bei gegensinnigem Radhub",
  "angle between the anti-roll bar's arm and its link":
    "Winkel zwischen Stabilisatorarm und Pendelstütze",
  "stiffness of the anti-roll bar with its blades":
    "Steifigkeit des Stabilisators mit seinen Blättern",
  "turn of the torsion bar from design": "Verdrehung des Drehstabs gegen Konstruktionslage",
  "torsion-bar motion ratio: its turn over wheel travel":
    "Drehstabübersetzung: seine Verdrehung über Radhub",
  "torque of the torsion bar": "Moment des Drehstabs",
  "length of the third spring, both wheels moving alike":
    "Länge der dritten Feder, beide Räder gleichsinnig",
  "third-spring motion ratio: its compression over the travel of both wheels":
    "Übersetzung der dritten Feder: ihr Weg über dem Hub beider Räder",
  "force of the third spring, both wheels moving alike":
    "Kraft der dritten Feder, beide Räder gleichsinnig",
  "force of the third spring at each wheel centre, both wheels moving alike":
    "Kraft der dritten Feder an jeder Radmitte, beide Räder gleichsinnig",
  "wheel rate of the third spring, both wheels moving alike":
    "Radfederrate der dritten Feder, beide Räder gleichsinnig",
  "damping coefficient of the third damper at each wheel centre, both wheels moving alike, about rest":
    "Dämpfungskonstante des dritten Dämpfers an jeder Radmitte, beide Räder gleichsinnig, um die Ruhelage",
  "force at each wheel centre while both wheels move alike: with third spring and Z-bar":
    "Kraft an jeder Radmitte bei gleichsinnigem Hub: mit dritter Feder und Z-Stabilisator",
  "wheel rate while both wheels move alike: with third spring and Z-bar":
    "Radfederrate bei gleichsinnigem Hub: mit dritter Feder und Z-Stabilisator",
  "turn of the rocker from design": "Drehung des Umlenkhebels gegen Konstruktionslage",
  "angle between push rod and rocker arm": "Winkel zwischen Druckstrebe und Umlenkhebelarm",
  "angle between spring and rocker arm": "Winkel zwischen Feder und Umlenkhebelarm",
  "steer gain: steer angle per rack travel": "Lenkwinkel je Zahnstangenweg",
  "kingpin inclination gain": "Spreizungsänderung über Radhub",
  "camber gain in steer, along the rack at the wheel centre's height":
    "Sturzänderung über Lenkeinschlag, entlang der Zahnstange bei gleicher Höhe der Radmitte",
  "change of the body's height above the ground at the wheel, from design":
    "Änderung der Höhe des Aufbaus über dem Boden am Rad gegen Konstruktionslage",
  "r.m.s. of the acceleration about its mean":
    "Effektivwert der Beschleunigung um ihren Mittelwert",
  "largest deviation of the acceleration from its mean":
    "größte Abweichung der Beschleunigung von ihrem Mittelwert",
  "r.m.s. of the angular acceleration about its mean":
    "Effektivwert der Winkelbeschleunigung um ihren Mittelwert",
  "weighted r.m.s. angular acceleration, We":
    "frequenzbewerteter Effektivwert der Winkelbeschleunigung, We",
  "weighted r.m.s. acceleration a_w (Wk vertical, Wd horizontal)":
    "frequenzbewerteter Effektivwert der Beschleunigung a_w (Wk vertikal, Wd horizontal)",
  "maximum transient vibration value: largest running r.m.s. over 1 s":
    "maximaler gleitender Effektivwert über 1 s (MTVV)",
  "maximum transient vibration value, exponential averaging":
    "maximaler gleitender Effektivwert, exponentiell gemittelt (MTVV)",
  "fourth power vibration dose value": "Schwingungsdosis der vierten Potenz (VDV)",
  "estimated vibration dose value, 1.4 a_w T^(1/4)": "geschätzte Schwingungsdosis, 1,4 a_w T^(1/4)",
  "largest weighted acceleration over a_w":
    "größte bewertete Beschleunigung über a_w (Scheitelfaktor)",
  "A(8): 1.4 a_w (x, y) or a_w (z), over the daily exposure":
    "A(8): 1,4 a_w (x, y) oder a_w (z), über die tägliche Einwirkung",
  "motion sickness dose value, Wf": "Dosiswert der Bewegungskrankheit, Wf",
  "share of unadapted people likely to vomit, MSDV_z / 300":
    "Anteil nicht angepasster Menschen, die sich voraussichtlich erbrechen, MSDV_z / 300",
  "a_v: root of the sum of squares of a_w over the axes recorded":
    "a_v: Wurzel der Quadratsumme von a_w über die gemessenen Achsen",
  "r.m.s. deflection of the strut about its mean":
    "Effektivwert des Federwegs um seinen Mittelwert",
  "largest minus smallest deflection of the strut": "größter minus kleinster Federweg",
  "largest share of the bump or rebound travel used, from the mean deflection":
    "größter genutzter Anteil des Ein- oder Ausfederwegs, von der mittleren Lage aus",
  "r.m.s. deflection over the whole travel available":
    "Effektivwert des Federwegs über dem verfügbaren Weg",
  "peak to peak deflection over the whole travel available":
    "Spitze-Spitze-Federweg über dem verfügbaren Weg",
  "number of bump stop contacts": "Zahl der Druckanschläge",
  "number of rebound stop contacts": "Zahl der Zuganschläge",
  "share of time on the bump stop": "Zeitanteil am Druckanschlag",
  "mean power into the strut (into the damper where its force is recorded)":
    "mittlere Leistung in das Federbein (in den Dämpfer, wo dessen Kraft gemessen ist)",
  "r.m.s. wheel load about its mean": "Effektivwert der Radlast um ihren Mittelwert",
  "standard deviation over mean of the wheel load":
    "Standardabweichung der Radlast über ihrem Mittelwert",
  "minimum wheel load": "kleinste Radlast",
  "minimum over mean wheel load": "kleinste über mittlerer Radlast",
  "share of time with the wheel off the ground": "Zeitanteil ohne Bodenkontakt",
  "mean fourth power of the wheel load over that of its mean":
    "Mittel der vierten Potenz der Radlast über der ihres Mittelwerts",
  "r.m.s. deflection of the tyre about its mean":
    "Effektivwert der Reifeneinfederung um ihren Mittelwert",
  "moment of driving on the body, nose down positive":
    "Moment aus dem Antrieb auf den Aufbau, Bug nach unten positiv",
  "moment given on the body, nose down positive":
    "vorgegebenes Moment auf den Aufbau, Bug nach unten positiv",
  "centre of gravity of the body": "Schwerpunkt des Aufbaus",
  "body pitch, nose down positive": "Nicken des Aufbaus, Bug nach unten positiv",
  "body pitch rate": "Nickgeschwindigkeit des Aufbaus",
  "body pitch acceleration": "Nickbeschleunigung des Aufbaus",
  "body roll, right side down positive": "Wanken des Aufbaus, rechte Seite nach unten positiv",
  "body roll rate": "Wankgeschwindigkeit des Aufbaus",
  "body roll acceleration": "Wankbeschleunigung des Aufbaus",
  "road height under the wheel": "Straßenhöhe unter dem Rad",
  "road height under the axle": "Straßenhöhe unter der Achse",
  "body above the wheel": "Aufbau über dem Rad",
  "body above the axle": "Aufbau über der Achse",
  "unsprung mass": "ungefederte Masse",
  "sprung mass": "gefederte Masse",
  "wheel centre": "Radmitte",
  "height above design": "Höhe über Konstruktionslage",
  "vertical velocity": "vertikale Geschwindigkeit",
  "vertical acceleration": "vertikale Beschleunigung",
  height: "Höhe",
  "from the design position": "von der Konstruktionslage aus",
  "strut deflection, compression positive": "Federweg, Einfedern positiv",
  "strut deflection rate, bump positive": "Federgeschwindigkeit, Einfedern positiv",
  "strut force of one wheel, compression positive": "Federbeinkraft eines Rades, Druck positiv",
  "tyre deflection from undeformed, compression positive":
    "Reifeneinfederung gegen unverformt, Druck positiv",
  "contact force of one wheel, compression positive": "Radlast eines Rades, Druck positiv",
  "lateral acceleration, to the left positive": "Querbeschleunigung, nach links positiv",
  "strut force, compression positive": "Federbeinkraft, Druck positiv",
  "contact force, compression positive": "Radlast, Druck positiv",
  "strut deflection from design, compression positive":
    "Federweg gegen Konstruktionslage, Einfedern positiv",
  "spring, stops, damper and friction, compression positive":
    "Feder, Anschläge, Dämpfer und Reibung, Druck positiv",
  "camber, positive top outward": "Sturz, oben nach außen positiv",
  "steer about +z": "Lenkwinkel um +z",
  "energy taken up by the spring": "von der Feder aufgenommene Energie",
  "energy taken up by the damper": "vom Dämpfer aufgenommene Energie",
  "energy taken up by the tyre": "vom Reifen aufgenommene Energie",
  "energy put in by the road": "von der Straße eingebrachte Energie",
  "kinetic energy": "kinetische Energie",
  "potential energy of the weights": "Lageenergie der Gewichte",
  "what is left open of the loops": "Restfehler der Schleifen",
  "guide friction on the sprung mass, up positive":
    "Führungsreibung an der gefederten Masse, nach oben positiv",
  "camber angle to the road": "Sturzwinkel zur Fahrbahn",
  "roll steer": "Eigenlenken beim Wanken",
  "roll camber": "Sturzänderung über Wankwinkel",
  "roll caster: caster angle over roll angle": "Nachlaufänderung über Wankwinkel",
  "track: distance of the contact points": "Spurweite: Abstand der Radaufstandspunkte",
  "roll centre height above the road": "Wankzentrumshöhe über der Fahrbahn",
  "roll centre, lateral distance from mid-track":
    "Wankzentrum, seitlicher Abstand von der Spurmitte",
  "moment of springs and anti-roll bar on the body":
    "Moment von Federn und Stabilisator auf den Aufbau",
  "roll stiffness of the springs": "Wanksteifigkeit der Federn",
  "roll stiffness of anti-roll bar and third spring":
    "Wanksteifigkeit von Stabilisator und dritter Feder",
  "roll stiffness of springs and anti-roll bar": "Wanksteifigkeit von Federn und Stabilisator",
  "roll stiffness of springs and anti-roll bar in series with the tyres":
    "Wanksteifigkeit von Federn und Stabilisator in Reihe mit den Reifen",
  "roll angle of the body": "Wankwinkel des Aufbaus",
  "longitudinal position": "Längsposition",
  "lateral position": "Querposition",
  "vertical position": "vertikale Position",
  "longitudinal velocity": "Längsgeschwindigkeit",
  "lateral velocity": "Quergeschwindigkeit",
  "longitudinal acceleration": "Längsbeschleunigung",
  "lateral acceleration": "Querbeschleunigung",
  acceleration: "Beschleunigung",
  "angular velocity": "Winkelgeschwindigkeit",
  "angular acceleration": "Winkelbeschleunigung",
  "minimum over static contact force": "kleinste über statischer Radlast",
  angle: "Winkel",
  "controller command": "Stellgröße des Reglers",
  "electric current": "elektrischer Strom",
  deflection: "Einfederung",
  "deflection velocity": "Einfedergeschwindigkeit",
  displacement: "Weg",
  distance: "Strecke",
  energy: "Energie",
  force: "Kraft",
  frequency: "Frequenz",
  length: "Länge",
  load: "Last",
  moment: "Moment",
  "phase angle": "Phasenwinkel",
  "pitch angle": "Nickwinkel",
  "pitch acceleration": "Nickbeschleunigung",
  "pitch rate": "Nickgeschwindigkeit",
  position: "Position",
  power: "Leistung",
  pressure: "Druck",
  "roll angle": "Wankwinkel",
  "roll acceleration": "Wankbeschleunigung",
  "roll rate": "Wankgeschwindigkeit",
  slope: "Steigung",
  speed: "Geschwindigkeit",
  stroke: "Hub",
  time: "Zeit",
  torque: "Drehmoment",
  travel: "Weg",
  velocity: "Geschwindigkeit",
  "constraint residual": "Restfehler der Bindungen",
  voltage: "Spannung",
  "yaw angle": "Gierwinkel",
  "yaw rate": "Giergeschwindigkeit",
  "root of the power spectral density": "Wurzel der spektralen Leistungsdichte",
  "wheel travel": "Radhub",
  "rack travel": "Zahnstangenweg",
  changed: "geändert",
  "as it is": "wie vorhanden",
};

translate({
  ...Object.fromEntries(Object.entries(WORDS).filter(([english]) => /\s/.test(english))),
  ...PARTS,
});

/** A quantity of the catalogue as a head names it; of an axle, with its side. */
export function quantity(name: string): string {
  const [side, own] = /^(left|right)\.(.*)$/.exec(name)?.slice(1) ?? ["", name];
  const said = isGerman ? NAMES[own!] : undefined;
  if (!said) return name.replaceAll("_", " ");
  return side ? `${said} ${PARTS[side]}` : said;
}

/** A key of a description, as its form names it. */
export function key(name: string): string {
  const plain = name.replaceAll("_", " ");
  return (isGerman && (KEYS[plain] ?? PARTS[plain])) || plain;
}

/** A hardpoint or a part. */
export function part(name: string): string {
  const plain = name.replaceAll("_", " ");
  return (isGerman && PARTS[plain]) || plain;
}

/** What a channel is, in the words of the page; its name, which files and commands use, stays. */
export function spoken(words: string): string {
  return isGerman ? (german(words) ?? words) : words;
}

/** Curves that came from the server, with what they are in the words of the page. */
export function inWords(store: Store): Store {
  if (isGerman) {
    for (const model of store.content.viewers) {
      model.x.words = spoken(model.x.words);
      for (const role of model.roles) role.label = spoken(role.label);
      for (const scene of model.scenes)
        for (const pane of scene.panes) {
          pane.words = spoken(pane.words);
          for (const curve of pane.curves) curve.label = spoken(curve.label);
        }
    }
  }
  return store;
}

function german(text: string): string | undefined {
  const own = text.trim();
  if (Object.hasOwn(WORDS, own)) return WORDS[own];
  const known = PARTS[own.replaceAll("_", " ")];
  if (known) return known;
  let found = /^(.*), difference from (.*)$/.exec(own);
  if (found) return `${found[1]}, Abweichung von ${spoken(found[2]!)}`;
  found = /^(.*), reaction (force|torque) along ([xyz])$/.exec(own);
  if (found)
    return `${german(found[1]!) ?? found[1]}, ${found[2] === "force" ? "Reaktionskraft" : "Reaktionsmoment"} entlang ${found[3]}`;
  found = /^place of (\w+)\.([xyz])$/.exec(own);
  if (found) return `Ort von ${part(found[1]!)}, ${found[2]}`;
  found = /^(left|right): (.*)$/.exec(own);
  if (found) {
    const said = german(found[2]!);
    return said && `${PARTS[found[1]!]}: ${said}`;
  }
  found = /^(Δ )?([a-z0-9_]+\.[a-z0-9_.]+), (.*)$/.exec(own); // a channel and what it is
  if (found) {
    const said = german(found[3]!);
    return said && `${found[1] ?? ""}${found[2]}, ${said}`;
  }
  found = /^(.*)([,;]) (.*)$/.exec(own); // two things that are known, the last of them alone
  if (found) {
    const [one, other] = [
      german(found[1]!),
      /^[xyz]$/.test(found[3]!) ? found[3]! : german(found[3]!),
    ];
    return one && other ? `${one}${found[2]} ${other}` : undefined;
  }
  return undefined;
}
