package rasterlab.engine.scene.obj;

import static rasterlab.engine.scene.obj.Rule.cut;
import static rasterlab.engine.scene.obj.Rule.passedOver;
import static rasterlab.engine.scene.obj.Rule.read;
import static rasterlab.engine.scene.obj.Rule.required;
import static rasterlab.engine.scene.obj.Rule.untold;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * The rules that models and materials are read by: the readers take ranges, values that stand for
 * missing ones and what is passed over from these tables, and engine/models.md shows them as one.
 *
 * <p>Three things stop a model: coordinates of a vertex that cannot be read, a corner of a face at
 * a vertex that is not there, and a file with no face that has an area, no line and no point. All
 * else is passed over, cut or replaced, with a note that counts and names the first place.
 *
 * <p>A keyword that is in no table is passed over with a note.
 */
final class ReadingRules {
    /** Magnitudes beyond this leave no room for squares in computing with floats. */
    static final double LARGEST = 1e18;

    private static final double BRIGHTEST = 1e6;
    private static final double SHARPEST = 1000;

    static final Rule POSITION = required("v", "x y z", LARGEST);
    static final Rule COLOR = cut("v", "red green blue behind x y z", 0, 1, 1);
    static final Rule WEIGHT = passedOver("v", "weight behind x y z");
    static final Rule PLACE = cut("vt", "s t", -LARGEST, LARGEST, 0);
    static final Rule NORMAL = read("vn", "x y z with a direction", "the face's own normal");
    static final Rule SMOOTHING =
            cut("s", "off or a group's number; on is 1", 0, Integer.MAX_VALUE, 0);

    /** The rules of a model, in the order of the table. */
    static final List<Rule> MODEL =
            List.of(
                    POSITION,
                    COLOR,
                    WEIGHT,
                    PLACE,
                    NORMAL,
                    read(
                            "f",
                            "v of at least 3 corners v, v/vt, v//vn, v/vt/vn",
                            "the file is refused"),
                    read("f", "vt", "place 0, 0 of the texture at all its corners"),
                    read("f", "vn", "the face's own normal"),
                    read("l", "v of at least 2 corners v, v/vt", "the line is left out"),
                    read("p", "v of any corners", "the point is left out"),
                    SMOOTHING,
                    read("mtllib", "one file's name, or several", "no materials"),
                    read("usemtl", "a material's name", "the default material of that name"),
                    untold("o", "a name"),
                    untold("g", "names"));

    static final List<String> MODEL_PASSED_OVER =
            List.of(
                    "vp",
                    "cstype",
                    "deg",
                    "bmat",
                    "step",
                    "curv",
                    "curv2",
                    "surf",
                    "parm",
                    "trim",
                    "hole",
                    "scrv",
                    "sp",
                    "end",
                    "con",
                    "mg",
                    "bevel",
                    "c_interp",
                    "d_interp",
                    "lod",
                    "usemap",
                    "maplib",
                    "shadow_obj",
                    "trace_obj",
                    "ctech",
                    "stech",
                    "call",
                    "csh",
                    "bzp",
                    "bsp",
                    "cdc",
                    "cdp",
                    "res");

    static final Rule AMBIENT = cut("Ka", "red green blue, or one number", 0, 1, 0.2);
    static final Rule DIFFUSE = cut("Kd", "red green blue, or one number", 0, 1, 0.8);
    static final Rule SPECULAR = cut("Ks", "red green blue, or one number", 0, 1, 0);
    static final Rule EMITTED = cut("Ke", "red green blue, or one number", 0, BRIGHTEST, 0);
    static final Rule SHININESS = cut("Ns", "exponent of the highlight", 0, SHARPEST, 0);
    static final Rule OPACITY =
            cut("d", "opacity; where no face would be seen, all are opaque", 0, 1, 1);
    static final Rule TRANSPARENCY = cut("Tr", "1 − opacity, where d is not given", 0, 1, 0);
    static final Rule ILLUMINATION = cut("illum", "the lighting model's number", 0, 10, 2);

    /** The rules of materials, in the order of the table. */
    static final List<Rule> MATERIALS =
            List.of(
                    read("newmtl", "the material's name", "an empty name"),
                    AMBIENT,
                    DIFFUSE,
                    SPECULAR,
                    EMITTED,
                    SHININESS,
                    OPACITY,
                    TRANSPARENCY,
                    ILLUMINATION,
                    read("map_Kd", "options and a picture's file", "the colour Kd"));

    static final List<String> MATERIALS_PASSED_OVER =
            List.of(
                    "Ni",
                    "Tf",
                    "Km",
                    "sharpness",
                    "map_Ka",
                    "map_Ks",
                    "map_Ke",
                    "map_Ns",
                    "map_d",
                    "map_Tr",
                    "map_aat",
                    "map_opacity",
                    "map_bump",
                    "bump",
                    "disp",
                    "decal",
                    "refl",
                    "norm",
                    "Pr",
                    "Pm",
                    "Ps",
                    "Pc",
                    "Pcr",
                    "aniso",
                    "anisor",
                    "map_Pr",
                    "map_Pm",
                    "map_Ps");

    static final Rule OFFSET = cut("-o", "u v w, added to s t", -LARGEST, LARGEST, 0);
    static final Rule SCALE = cut("-s", "u v w, times s t, before -o", -LARGEST, LARGEST, 1);
    static final Rule CLAMP = read("-clamp", "on or off", "off");

    /** The options of a texture's file name, with the most words that each takes. */
    static final Map<Rule, Integer> OPTIONS =
            Map.ofEntries(
                    Map.entry(OFFSET, 3),
                    Map.entry(SCALE, 3),
                    Map.entry(CLAMP, 1),
                    Map.entry(passedOver("-t", "u v w"), 3),
                    Map.entry(passedOver("-mm", "base gain"), 2),
                    Map.entry(passedOver("-bm", "number"), 1),
                    Map.entry(passedOver("-boost", "number"), 1),
                    Map.entry(passedOver("-texres", "number"), 1),
                    Map.entry(passedOver("-blendu", "on or off"), 1),
                    Map.entry(passedOver("-blendv", "on or off"), 1),
                    Map.entry(passedOver("-cc", "on or off"), 1),
                    Map.entry(passedOver("-imfchan", "channel"), 1),
                    Map.entry(passedOver("-type", "kind of map"), 1),
                    Map.entry(passedOver("-colorspace", "space"), 1));

    private static final Map<String, Rule> OF_MODEL = byKeyword(MODEL, MODEL_PASSED_OVER);
    private static final Map<String, Rule> OF_MATERIALS =
            byKeyword(MATERIALS, MATERIALS_PASSED_OVER);

    private ReadingRules() {}

    private static Map<String, Rule> byKeyword(List<Rule> rules, List<String> passedOver) {
        var byKeyword = new TreeMap<String, Rule>(String.CASE_INSENSITIVE_ORDER);
        for (Rule rule : rules) byKeyword.putIfAbsent(rule.keyword(), rule);
        for (String keyword : passedOver) byKeyword.put(keyword, passedOver(keyword, ""));
        return byKeyword;
    }

    /** The rule of a keyword exactly as written: f and F are two. */
    static Optional<Rule> ofModel(String keyword) {
        return Optional.ofNullable(OF_MODEL.get(keyword))
                .filter(rule -> rule.keyword().equals(keyword));
    }

    /** Whether it is written map_Kd, map_kd or otherwise. */
    static Optional<Rule> ofMaterials(String keyword) {
        return Optional.ofNullable(OF_MATERIALS.get(keyword));
    }

    static Optional<Rule> ofOption(String option) {
        return OPTIONS.keySet().stream().filter(rule -> rule.keyword().equals(option)).findAny();
    }

    /** The most words that an option takes. */
    static int mostWords(Rule option) {
        return OPTIONS.get(option);
    }
}
