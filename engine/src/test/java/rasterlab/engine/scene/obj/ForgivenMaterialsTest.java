package rasterlab.engine.scene.obj;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Values that materials must not have are cut, replaced or passed over, and that is told. */
class ForgivenMaterialsTest {
    private static final String MODEL =
            "mtllib m.mtl\n" + Texts.SQUARE + "vt 0 0\nusemtl a\nf 1/1 2/1 3/1";

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("values")
    void takesWhatItCan(
            String mtl, Function<ObjMaterial, Object> value, Object expected, String... notes)
            throws Exception {
        ObjModel model = Texts.read(MODEL, "newmtl a\n" + mtl);
        assertEquals(expected, value.apply(model.materials().get(model.material(0))));
        assertEquals(List.of(notes), model.notes());
    }

    private static Arguments value(
            String mistake,
            String mtl,
            Function<ObjMaterial, Object> value,
            Object expected,
            String... notes) {
        return argumentSet(mistake, mtl, value, expected, notes);
    }

    static Stream<Arguments> values() {
        return Stream.of(ofNumbers(), ofMaps(), ofSpoiledOptions()).flatMap(values -> values);
    }

    private static Stream<Arguments> ofNumbers() {
        return Stream.of(
                value(
                        "a colour above 1 stops a model",
                        "Ka 20 20 0.5",
                        ObjMaterial::ambient,
                        List.of(1.0, 1.0, 0.5),
                        "m.mtl:2: 'Ka' of 20 was cut to its range, 0 to 1 (2 times)"),
                value(
                        "a colour below 0 stops a model",
                        "Kd 1.0001 -0.5 0.5",
                        ObjMaterial::diffuse,
                        List.of(1.0, 0.0, 0.5),
                        "m.mtl:2: 'Kd' of 1.0001 was cut to its range, 0 to 1 (2 times)"),
                value(
                        "two thirds of a colour stop a model",
                        "Ks 1 1",
                        ObjMaterial::specular,
                        List.of(0.0, 0.0, 0.0),
                        "m.mtl:2: 'Ks' has too few numbers; 0 is used instead"),
                value(
                        "a decimal comma stops a model, or is not named",
                        "Kd 0,5 0,5 0,5",
                        ObjMaterial::diffuse,
                        List.of(0.8, 0.8, 0.8),
                        "m.mtl:2: 'Kd' has a decimal comma in '0,5'; 0.8 is used instead"),
                value(
                        "a colour by its spectrum stops a model",
                        "Kd spectral red.rfl 1",
                        ObjMaterial::diffuse,
                        List.of(0.8, 0.8, 0.8),
                        "m.mtl:2: 'Kd' has no number in 'spectral'; 0.8 is used instead"),
                value(
                        "an exponent above 1000 stops a model",
                        "Ns 1000.5",
                        ObjMaterial::shininess,
                        1000.0,
                        "m.mtl:2: 'Ns' of 1000.5 was cut to its range, 0 to 1000"),
                value(
                        "an opacity above 1 stops a model",
                        "d 1.5",
                        ObjMaterial::opacity,
                        1.0,
                        "m.mtl:2: 'd' of 1.5 was cut to its range, 0 to 1"),
                value(
                        "halo is a number",
                        "d -halo 0.5",
                        ObjMaterial::opacity,
                        0.5,
                        "m.mtl:2: option '-halo' was passed over"),
                value("Tr counts before d", "d 0.75\nTr 0.75", ObjMaterial::opacity, 0.75),
                value(
                        "lighting model 11 stops a model",
                        "illum 11",
                        ObjMaterial::illumination,
                        10,
                        "m.mtl:2: 'illum' of 11 was cut to its range, 0 to 10"),
                value(
                        "half a lighting model stops a model",
                        "illum 1.5",
                        ObjMaterial::illumination,
                        2,
                        "m.mtl:2: 'illum' has no number in '1.5'; 2 is used instead"));
    }

    private static ObjMaterial.Map map(ObjMaterial material) {
        return material.diffuseMap().orElseThrow();
    }

    private static Arguments option(String mistake, String mtl, Object expected, String... notes) {
        return value(
                mistake,
                mtl,
                m -> List.of(map(m).names(), map(m).offset(), map(m).scale()),
                expected,
                notes);
    }

    private static Stream<Arguments> ofSpoiledOptions() {
        List<Double> none = List.of(0.0, 0.0);
        List<Double> whole = List.of(1.0, 1.0);
        List<String> tex = List.of("tex.png");
        return Stream.of(
                option(
                        "a decimal comma of an offset is the file's name",
                        "map_Kd -o 1,5 0 0 tex.png",
                        List.of(tex, none, whole),
                        "m.mtl:2: '-o' has a decimal comma in '1,5'; 0 is used instead"),
                option(
                        "the last decimal comma is the file's name",
                        "map_Kd -s 2 2 0,5 tex.png",
                        List.of(tex, none, List.of(2.0, 2.0)),
                        "m.mtl:2: '-s' has a decimal comma in '0,5'; 1 is used instead"),
                option(
                        "no number of a scale is the file's name",
                        "map_Kd -s nan 3 -o -1.#IND00 inf tex.png",
                        List.of(tex, none, List.of(1.0, 3.0)),
                        "m.mtl:2: '-s' has no number in 'nan'; 1 is used instead",
                        "m.mtl:2: '-o' has no number in '-1.#IND00'; 0 is used instead (2 times)"),
                option(
                        "a word before numbers is the file's name",
                        "map_Kd -o x 2 tex.png",
                        List.of(tex, List.of(0.0, 2.0), whole),
                        "m.mtl:2: '-o' has no number in 'x'; 0 is used instead"),
                option(
                        "a word behind numbers is surely the file's name, or surely none",
                        "map_Kd -o 1 2 x tex.png",
                        List.of(List.of("x tex.png", "tex.png"), List.of(1.0, 2.0), whole)),
                option(
                        "a name is cut though the option has all its numbers",
                        "map_Kd -o 1 2 0 x tex.png",
                        List.of(List.of("x tex.png"), List.of(1.0, 2.0), whole)),
                option(
                        "what another option leaves out is the file's name",
                        "map_Kd -mm 0,5 1 -bm x tex.png",
                        List.of(tex, none, whole),
                        "m.mtl:2: option '-mm' was passed over",
                        "m.mtl:2: option '-bm' was passed over"));
    }

    private static Stream<Arguments> ofMaps() {
        return Stream.of(
                value(
                        "another case of a keyword is another keyword",
                        "map_kd a.png",
                        m -> map(m).names(),
                        List.of("a.png")),
                value(
                        "a comment sign within a name begins a comment",
                        "map_Kd wood#2.png",
                        m -> map(m).names(),
                        List.of("wood#2.png")),
                value(
                        "options are the file's name",
                        "map_Kd -o 0.0 -7.0 0.0 -s 1.0 10.0 1.0 -clamp on my tex.png",
                        m ->
                                List.of(
                                        map(m).names(),
                                        map(m).offset(),
                                        map(m).scale(),
                                        map(m).clamped()),
                        List.of(
                                List.of("my tex.png"),
                                List.of(0.0, -7.0),
                                List.of(1.0, 10.0),
                                true)),
                value(
                        "an option takes the file's name for its number",
                        "map_Kd -s 2 2.png",
                        m -> List.of(map(m).names(), map(m).scale()),
                        List.of(List.of("2.png"), List.of(2.0, 1.0))),
                value(
                        "an option that is not done takes the name with it",
                        "map_Kd -mm 0 1 -blendu off -type sphere -foo 3 a.png",
                        m -> map(m).names(),
                        List.of("a.png"),
                        "m.mtl:2: option '-mm' was passed over",
                        "m.mtl:2: option '-blendu' was passed over",
                        "m.mtl:2: option '-type' was passed over",
                        "m.mtl:2: unknown option '-foo' was passed over"),
                value(
                        "a hyphen always begins an option",
                        "map_Kd -wood.png",
                        m -> map(m).names(),
                        List.of("-wood.png")),
                value(
                        "a texture without a file stops a model",
                        "map_Kd",
                        ObjMaterial::diffuseMap,
                        Optional.empty(),
                        "m.mtl:2: 'map_Kd' without a file's name was passed over"));
    }

    @Test
    @DisplayName("a value of no material stops a model")
    void passesOverWhatComesBeforeMaterials() throws Exception {
        ObjModel model = Texts.read(MODEL, "Kd 1 0 0\nnewmtl a\nKd 0 1 0\nnewmtl\n");
        assertEquals(List.of(0.0, 1.0, 0.0), model.materials().get(model.material(0)).diffuse());
        assertEquals(
                List.of(
                        "m.mtl:1: 'Kd' before the first 'newmtl' was passed over",
                        "m.mtl:4: 'newmtl' has no name"),
                model.notes());
    }

    /** The second line of each pair names another material than the first. */
    @ParameterizedTest(name = "{0} and {1} become one")
    @MethodSource("names")
    void namesThatDifferStayDifferent(String one, String other) throws Exception {
        String mtl = "newmtl " + one + "\nKd 1 0 0\nnewmtl " + other + "\nKd 0 1 0\n";
        String faces =
                Texts.SQUARE + "usemtl " + one + "\nf 1 2 3\nusemtl " + other + "\nf 2 3 4\n";
        ObjModel known = Texts.read("mtllib m.mtl\n" + faces, mtl);
        ObjModel unknown = Texts.read(faces);
        assertEquals(List.of(1.0, 0.0, 0.0), known.materials().get(known.material(0)).diffuse());
        assertEquals(List.of(0.0, 1.0, 0.0), known.materials().get(known.material(1)).diffuse());
        assertNotEquals(unknown.material(0), unknown.material(1));
    }

    static Stream<Arguments> names() {
        return Stream.of(
                Arguments.of("Material #25", "Material #26"),
                Arguments.of("Material # 25", "Material # 26"),
                Arguments.of("a#1", "a#2"),
                Arguments.of("#1", "#2"),
                Arguments.of("red", "red\u00A0"),
                Arguments.of("red", "red #"),
                Arguments.of("a b", "a  b"),
                Arguments.of("сталь", "медь"),
                Arguments.of("Red", "red"));
    }

    /** The names have no material, and without its end each would be that of another one. */
    @ParameterizedTest(name = "{0} and {1} become one beside a material {2}")
    @CsvSource({"Mat #1, Mat #2, Mat", "Mat, Mat #2, Mat #3", "Mat #1, Mat, Mat"})
    void namesWithoutAMaterialBecomeNoOther(String one, String other, String material)
            throws Exception {
        String faces =
                Texts.SQUARE + "usemtl " + one + "\nf 1 2 3\nusemtl " + other + "\nf 2 3 4\n";
        ObjModel model =
                Texts.read("mtllib m.mtl\n" + faces, "newmtl " + material + "\nKd 1 0 0\n");
        assertNotEquals(model.material(0), model.material(1));
        List<List<Double>> shown =
                Stream.of(0, 1)
                        .map(face -> model.materials().get(model.material(face)).diffuse())
                        .toList();
        List<Double> standard = List.of(0.8, 0.8, 0.8);
        List<Double> red = List.of(1.0, 0.0, 0.0);
        assertEquals(
                Stream.of(one, other).map(name -> name.equals(material) ? red : standard).toList(),
                shown);
        String missing = one.equals(material) ? other : one;
        int missed = one.equals(material) || other.equals(material) ? 1 : 2;
        assertEquals(
                List.of(
                        "a.obj:%d: there is no material '%s'; the default one stands for it%s"
                                .formatted(
                                        one.equals(material) ? 8 : 6,
                                        missing,
                                        missed == 1 ? "" : " (2 times)")),
                model.notes());
    }

    @Test
    @DisplayName("a material given twice is told at the model's line, without its name")
    void namesTheMaterialThatIsGivenTwice() throws Exception {
        ObjModel model = Texts.read(MODEL, "newmtl a\nKd 1 0 0\n\nnewmtl a\nKd 0 1 0\n");
        assertEquals(List.of(1.0, 0.0, 0.0), model.materials().get(model.material(0)).diffuse());
        assertEquals(
                List.of("m.mtl:4: material 'a' is given twice; the first counts"), model.notes());
    }

    @Test
    @DisplayName("a comment behind a name is part of it though no material has such a name")
    void findsTheMaterialInFrontOfAComment() throws Exception {
        String mtl = "newmtl red # the first\nKd 1 0 0\n";
        ObjModel model =
                Texts.read("mtllib m.mtl # all\n" + Texts.SQUARE + "usemtl red\nf 1 2 3", mtl);
        assertEquals(List.of(1.0, 0.0, 0.0), model.materials().get(model.material(0)).diffuse());
        assertEquals(
                List.of(
                        "a.obj:1: there is no material file 'm.mtl # all'; 'm.mtl' was taken, since a"
                                + " # behind a blank may begin a comment",
                        "a.obj:6: there is no material 'red'; 'red # the first' was taken, since a #"
                                + " behind a blank may begin a comment"),
                model.notes());
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("vanishing")
    void showsWhatWouldVanish(String mtl, double opacity, List<String> notes) throws Exception {
        String model = MODEL + "\nusemtl b\nf 2 3 4";
        ObjModel read = Texts.read(model, mtl);
        assertEquals(opacity, read.materials().get(read.material(0)).opacity());
        assertEquals(notes, read.notes());
    }

    static Stream<Arguments> vanishing() {
        return Stream.of(
                argumentSet(
                        "a picture is empty without a word",
                        "newmtl a\nTr 1.000000\nnewmtl b\nd 0\n",
                        1.0,
                        List.of(
                                "a.obj: 'd' or 'Tr' makes all faces transparent altogether; they are"
                                        + " drawn opaque")),
                argumentSet(
                        "glass that nobody sees becomes opaque beside faces that are seen",
                        "newmtl a\nTr 1\nnewmtl b\nd 0.5\n",
                        0.0,
                        List.of(
                                "a.obj: a face that 'd' or 'Tr' makes transparent altogether is not"
                                        + " seen")));
    }
}
