package rasterlab.app.cli.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.cli.Ran;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.scene.catalogue.Scenes;

class RenderCommandTest {
    @TempDir Path folder;

    @Test
    void pictureHasNoWrongPixelAgainstItself() throws Exception {
        Path picture = rendered("painter-textbook", "160x120");
        JsonNode diff = diff("--visibility", "painter-textbook", "--diff", picture.toString());
        assertEquals(0, diff.path("wrongPixels").asInt());
        assertEquals(160 * 120, diff.path("pixels").asInt());
    }

    @Test
    void faultyPainterDiffersFromTheReference() throws Exception {
        Path picture = rendered("painter-textbook", "160x120");
        JsonNode diff = diff("--reference", "--diff", picture.toString());
        assertTrue(diff.path("wrongPixels").asInt() > 0, diff.toString());
        assertTrue(diff.path("largestLevelDifference").asInt() > 0, diff.toString());
    }

    @Test
    void referenceIsTheExactPictureWhateverElseIsAsked() throws Exception {
        String out = folder.resolve("r.png").toString();
        Ran ran = render("--visibility", "painter", "--reference", "--size", "8x6", "--out", out);
        assertEquals("exact", new ObjectMapper().readTree(ran.out()).path("visibility").asText());
    }

    @Test
    void stagesAreMeasuredOnlyWhereTheyAreAskedFor() throws Exception {
        String out = folder.resolve("s.png").toString();
        Ran silent = render("--size", "8x6", "--out", out);
        assertFalse(new ObjectMapper().readTree(silent.out()).has("measured"), silent.out());
        Ran ran = render("--size", "8x6", "--stages");
        ran.assertDone();
        JsonNode measured = new ObjectMapper().readTree(ran.out()).path("measured");
        assertTrue(measured.path("stages").has("fragments"), ran.out());
        double shares = 0;
        for (JsonNode share : measured.path("shares")) shares += share.asDouble();
        assertEquals(1, shares, 0.001, ran.out());
    }

    @Test
    void picturesWithoutStagesAreRefused() {
        assertEquals(2, render("--reference", "--stages").exitCode());
        assertEquals(2, render("--shading", "wire", "--stages").exitCode());
    }

    private Path rendered(String visibility, String size) {
        Path picture = folder.resolve("a.png");
        String[] options = {"--visibility", visibility, "--size", size, "--out", "" + picture};
        render(options).assertDone();
        return picture;
    }

    private static JsonNode diff(String... options) throws Exception {
        String[] sized = Arrays.copyOf(options, options.length + 2);
        sized[options.length] = "--size";
        sized[options.length + 1] = "160x120";
        Ran ran = render(sized);
        ran.assertDone();
        return new ObjectMapper().readTree(ran.out()).path("diff");
    }

    private static Ran render(String... options) {
        return Ran.lab(
                Stream.concat(Stream.of("render", "vase"), Arrays.stream(options))
                        .toArray(String[]::new));
    }

    @Test
    void cameraTakesMultiplesOfPi() throws Exception {
        String out = folder.resolve("b.png").toString();
        Ran ran = render("--camera", "-0.5,0.25pi,900", "--size", "8x6", "--out", out);
        ran.assertDone();
        JsonNode camera = new ObjectMapper().readTree(ran.out()).path("camera");
        assertEquals(Math.PI / 4, camera.path("phi").asDouble());
        assertEquals(-0.5, camera.path("theta").asDouble());
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void oneLineSaysWhatIsWrong(String part, String[] options) {
        String out = folder.resolve("c.png").toString();
        String[] all = Arrays.copyOf(options, options.length + 2);
        all[options.length] = "--out";
        all[options.length + 1] = out;
        Ran ran = render(all);
        assertTrue(ran.err().contains(part), ran.err());
        assertEquals(1, ran.err().lines().count(), ran.err());
        assertEquals("", ran.out());
        assertEquals(2, ran.exitCode());
        assertFalse(Files.exists(Path.of(out)), "no picture is left");
    }

    @Test
    void methodThatCannotDrawTheSceneRefuses() {
        String out = folder.resolve("d.png").toString();
        Ran ran = render("--visibility=convex", "--out", out);
        assertEquals(3, ran.exitCode());
        assertTrue(
                ran.err().startsWith("./lab render: convex refuses: the scene must be one convex"),
                ran.err());
        assertFalse(Files.exists(Path.of(out)), "no picture is left");
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                mistake("visibility is unknown", "there are none, back-face,", "--visibility=z"),
                mistake("shading is unknown", "there are tone, wire, flat,", "--shading=fong"),
                mistake("projection is unknown", "perspective, parallel", "--projection=fisheye"),
                mistake("size has no height", "expected WIDTHxHEIGHT", "--size=80"),
                mistake("size is 0", "from 1×1 to 8192×8192 pixels, got 0×9", "--size=0x9"),
                mistake("size is too large", "got 8193×1", "--size=8193x1"),
                mistake("zoom is 0", "zoom must be from 1e-6 to 1000000, got 0", "--zoom=0"),
                mistake("zoom is not finite", "to 1000000, got Infinity", "--zoom=Infinity"),
                mistake(
                        "method has no outlines",
                        "'zfloat' draws no outlines",
                        "--visibility=zfloat",
                        "--outline"),
                mistake("reference is outlined", "draws no", "--reference", "--outline"),
                mistake("camera has two numbers", "expected theta,phi,rho", "--camera=1,2"),
                mistake("camera is no number", "'x' is not a number", "--camera=1,x,3"),
                mistake("camera is not finite", "finite angle", "--camera=NaN,1,3"),
                mistake("camera is in the origin", "got 0", "--camera=1,1,0"),
                mistake(
                        "far is before near",
                        "--near must be below --far 3, got 9",
                        "--near=9",
                        "--far=3"),
                mistake("far is before the usual near", "--far must be above near", "--far=1e-9"),
                mistake(
                        "near is in the eye",
                        "--near must be above 0 in perspective, at least",
                        "--near=0"),
                mistake("texture filter is unknown", "no texture filter 'x'", "--texture=x"),
                mistake("term is unknown", "no light term 'glow'", "--terms=ambient,glow"),
                mistake("culled side is unknown", "none, back, front", "--cull=left"),
                mistake(
                        "hidden lines are unknown",
                        "removed, dashed",
                        "--shading=wire",
                        "--hidden-lines=x"),
                mistake("stereo is unknown", "anaglyph, side-by-side", "--stereo=3d"),
                mistake("eyes have no number", "such as 3deg", "--stereo=anaglyph", "--eyes=deg"),
                mistake(
                        "hidden lines of filled faces",
                        "--hidden-lines needs --shading wire",
                        "--hidden-lines=shown"),
                mistake("crease of filled faces", "--crease needs", "--crease=20"),
                mistake("eyes of one picture", "--eyes needs --stereo", "--eyes=3"),
                mistake("stereo is parallel", "needs perspective", PARALLEL, "--stereo=anaglyph"),
                mistake("depth cue is too strong", "up to 1, got 3", "--depth-cue=3"),
                mistake(
                        "filter of nothing",
                        "--texture nearest needs a texture; scene 'vase' has none",
                        "--texture=nearest"),
                mistake("wrap needs a texture", "scene 'vase' has none", "--wrap=repeat"),
                mistake(
                        "wrap of what is not shown",
                        "--texture none shows none",
                        "--wrap=repeat",
                        "--texture=none"),
                mistake("near is a word", "'nan' is not a number; expected", "--near=nan"),
                mistake(
                        "eyes are huge",
                        "render: separation must be above 0",
                        GLASSES,
                        "--eyes=1e300"),
                mistake("eyes are one", "distance must be above 0, got '0'", GLASSES, "--eyes=0"),
                mistake("angle is huge", "1000000 radians, got '1e300'", "--camera=1e300,1,5"),
                mistake("zoom is huge", "to 1000000, got 1e300", "--zoom=1e300"),
                mistake(
                        "no term",
                        "--terms ',' has an empty name; expected some of amb",
                        "--terms=,"),
                mistake("term without a name", "'ambient,' has an empty", "--terms=ambient,"),
                mistake("first term without one", "',ambient' has an", "--terms=,ambient"),
                mistake("term is given twice", "'ambient' twice", "--terms=ambient,ambient"),
                mistake("light of wires", "--terms needs light", WIRE, "--terms=ambient"),
                mistake(
                        "light of tones",
                        "--terms needs light",
                        "--shading=tone",
                        "--terms=ambient"),
                mistake("backs of wires", "--two-sided needs light", WIRE, "--two-sided"),
                mistake("texture of wires", "--texture-image, --wrap", WIRE, "--texture=nearest"),
                mistake("wrap of wires", "need faces", WIRE, "--wrap=repeat"),
                mistake("errors of wires", "--errors needs faces", WIRE, "--errors"),
                mistake(
                        "errors of surfaces",
                        "--errors needs faces",
                        "--visibility=raycast-surface",
                        "--errors"),
                mistake("outlines of wires", "--outline needs faces", WIRE, "--outline"),
                mistake("up of a scene", "--up is for a model", "--up=y"),
                mistake("texture is missing", "no such file", "--texture-image=no.png"),
                mistake("texture is text", "is not a picture", "--texture-image=pom.xml"),
                mistake("other picture is missing", "no such file to read", "--diff=no.png"),
                mistake("other picture is a folder", "is a folder", "--diff=."),
                mistake("other picture is text", "is not a PNG picture", "--diff=pom.xml"));
    }

    private static final String GLASSES = "--stereo=anaglyph";
    private static final String WIRE = "--shading=wire";
    private static final String PARALLEL = "--projection=parallel";

    private static Arguments mistake(String name, String part, String... options) {
        return argumentSet(name, part, options);
    }

    @Test
    void otherPictureOfAnotherSizeOrBroken() throws Exception {
        Path picture = rendered("zfloat", "16x12");
        Ran.lab("render", "vase", "--diff", picture.toString())
                .assertComplains(
                        2,
                        "./lab render: "
                                + picture
                                + ": has 16×12 pixels, the rendered picture 800×600;"
                                + " sizes must be equal");
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("broken")
    void saysHowTheOtherPictureIsBroken(int kept, String reason) throws Exception {
        byte[] whole = Files.readAllBytes(rendered("zfloat", "16x12"));
        Path part = folder.resolve("part.png");
        Files.write(part, Arrays.copyOf(whole, Math.min(kept, whole.length / 2)));
        Ran ran = render("--diff", part.toString(), "--size", "16x12");
        assertTrue(ran.err().startsWith("./lab render: " + part + ": " + reason), ran.err());
        assertFalse(ran.err().contains("null"), ran.err());
        assertEquals(2, ran.exitCode());
    }

    static Stream<Arguments> broken() {
        return Stream.of(
                argumentSet("empty file is broken", 0, "the file is empty; expected a whole PNG"),
                argumentSet("sign is cut", 5, "the picture is cut off"),
                argumentSet("header is cut", 20, "the picture is cut off"),
                argumentSet("pixels are cut", 1 << 20, "the picture is cut off"));
    }

    @Test
    void helpNamesEveryMethodThatTheEngineHas() {
        String help = Ran.lab("render", "--help").out().replaceAll("\\s+", " ");
        for (String name : Renderer.visibilities()) assertTrue(help.contains(name), name);
        for (String name : Scenes.names()) assertTrue(help.contains(name), name);
        assertTrue(Ran.lab("completion").out().contains("painter-textbook"), "not completed");
    }

    @Test
    void unknownSceneAndNothingToDo() {
        Ran.lab("render", "vas", "--out", "x.png")
                .assertComplains(
                        2,
                        "./lab render: no scene 'vas'; there are "
                                + String.join(", ", Scenes.names())
                                + "; did you mean 'vase'?");
        Ran.lab("render", "vase")
                .assertComplains(
                        2,
                        "./lab render: nothing to do; give --out FILE.png, --diff OTHER.png"
                                + ", --errors or --stages");
    }

    @Test
    void reportNamesEverythingThatWasUsed() throws Exception {
        String out = folder.resolve("d.png").toString();
        Ran ran =
                render(
                        "--shading=auto",
                        "--projection=isometric",
                        "--far=600",
                        "--cull=back",
                        "--terms=diffuse",
                        "--depth-cue",
                        "--no-two-sided",
                        "--size=20x10",
                        "--out=" + out);
        ran.assertDone();
        JsonNode report = new ObjectMapper().readTree(ran.out());
        assertEquals("flat", report.path("shading").asText());
        assertEquals(
                "corners have no normals of their own", report.path("shadingBecause").asText());
        assertEquals("none", report.path("texture").asText());
        assertFalse(report.path("camera").path("anglesUsed").asBoolean(true));
        assertTrue(report.path("near").isNull(), "nothing is too near in parallel projection");
        assertEquals(600, report.path("far").asDouble());
        assertEquals("back", report.path("cull").asText());
        assertEquals("[\"diffuse\"]", report.path("terms").toString());
        assertEquals(0.8, report.path("depthCue").asDouble());
        assertFalse(report.path("twoSided").asBoolean(true));
    }

    @Test
    void errorsOfCheaperShadingsAreCounted() throws Exception {
        Ran ran = render("--errors", "--size=80x60");
        ran.assertDone();
        JsonNode errors = new ObjectMapper().readTree(ran.out()).path("errorsAgainstPhong");
        for (String shading : new String[] {"flat", "gouraud"}) {
            assertEquals(4800, errors.path(shading).path("pixels").asInt(), shading);
            assertTrue(errors.path(shading).path("largestLevelDifference").asInt() > 0, shading);
        }
    }

    @Test
    void eyesAreTakenInUnitsAndDegrees() throws Exception {
        String out = folder.resolve("e.png").toString();
        for (String[] eyes : new String[][] {{"20", "20"}, {"90deg", "1000"}}) {
            Ran ran =
                    render(
                            "--stereo=side-by-side",
                            "--eyes=" + eyes[0],
                            "--size=20x10",
                            "--out=" + out);
            ran.assertDone();
            JsonNode report = new ObjectMapper().readTree(ran.out());
            assertEquals(Double.parseDouble(eyes[1]), report.path("eyes").asDouble(), 1e-9);
        }
    }
}
