package rasterlab.app.light;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Language;
import rasterlab.app.outcome.Pipe;
import rasterlab.contract.Reflection;
import rasterlab.engine.light.LightTerm;
import rasterlab.engine.light.Substance;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.scene.obj.UpAxis;
import rasterlab.engine.transform.SphericalView;

@Tag("slow")
@Timeout(300)
class OpenedLitSceneTest {
    @TempDir Path folder;

    private final ModelThread thread = new ModelThread();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final LightLabModel model = new LightLabModel(thread, failures::add);

    @AfterEach
    void close() {
        model.close();
        assertEquals(List.of(), failures);
    }

    @ParameterizedTest(name = "a saved scene is opened with other light or material: {0}")
    @EnumSource(LightHazard.class)
    void opensWhatWasSaved(LightHazard hazard) {
        assertOpened(hazard.shown());
    }

    @Test
    @DisplayName("a setting of the lab is lost between saving and opening")
    void opensAllThatWasChosen() {
        Lamp spot =
                Lamp.at(50, 60, 90)
                        .withKind(Lamp.LampKind.SPOT)
                        .withCutoff(33)
                        .withExponent(7)
                        .colored(0x804020)
                        .withStrength(1.3);
        Lamp faint = Lamp.at(-80, 3, 20).attenuated(0.7, 0.3, 0.11).colored(0x336699);
        Lamp sun = Lamp.at(1, 2, 3).withKind(Lamp.LampKind.SUN).withStrength(0.35);
        assertOpened(
                LightChoice.first()
                        .with(new LitBody("torus", 9, "angle"))
                        .with(new SphericalView(0.2, 0.9, 777))
                        .withZoom(2.25)
                        .withLamps(List.of(spot, faint, sun))
                        .with(
                                MaterialChoice.of(Substance.RUBY)
                                        .withAmbient(1.7)
                                        .withDiffuse(0.4)
                                        .withSpecular(1.9)
                                        .withEmission(0.2)
                                        .withShininess(150))
                        .with(Reflection.PHONG)
                        .withAmbient(0.37)
                        .withTerms(Set.of(LightTerm.DIFFUSE, LightTerm.EMISSION))
                        .withLocalViewer(false)
                        .withTwoSides(false));
    }

    @Test
    @DisplayName("a Wavefront model is called no JSON, or it brings other lamps")
    void opensAModel() throws Exception {
        Path file = folder.resolve("Pyramid.OBJ");
        Files.writeString(
                file, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
        LightChoice before = model.state().choice();
        OpenedLitScene opened = OpenedLitScene.read(file, before);
        assertEquals(before, opened.choice().with(before.body()));
        assertEquals(4, opened.choice().body().scene().mesh().faceCount());
        assertEquals(
                file + ": y is taken to point up; the chooser of the axis turns the model",
                opened.notes(file));
        LightChoice again = OpenedLitScene.again(file, UpAxis.Y, before).choice();
        assertEquals("Pyramid.OBJ", again.body().name());
    }

    @ParameterizedTest(name = "it is not told what this tab opens instead of {0}")
    @CsvSource(
            delimiter = '|',
            value = {
                "notes.txt | unknown extension; allowed are .obj and .scene.json",
                "empty | unknown extension; allowed are .obj and .scene.json",
                "a.scene.json | the file is empty; a scene file is an object {…}",
                "a.obj | no face with an area, no line and no point is in it",
            })
    void tellsWhatItOpens(String name, String why) throws Exception {
        Path file = Files.writeString(folder.resolve(name), name.equals("notes.txt") ? "a" : "");
        model.open(file);
        thread.settle(model::settle);
        String told = model.state().problem();
        assertTrue(told.startsWith(file + ": ") && told.contains(why), told);
    }

    @Test
    @DisplayName("why a file was not opened stays after the next choice")
    void forgetsAProblemOnceTheUserGoesOn() {
        model.tellProblem("a.txt: unknown extension");
        model.choose(choice -> choice);
        assertEquals("", model.state().problem());
        model.tellProblem("a.txt: unknown extension");
        model.reset();
        assertEquals("", model.state().problem());
    }

    private void assertOpened(LightChoice saved) {
        Path file = folder.resolve("lit.scene.json");
        LitSceneFile.write(saved, file);
        LightChoice before = model.state().choice();
        open(file);
        LightChoice opened = model.state().choice();
        assertEquals("", model.state().problem());
        assertArrayEquals(picture(saved), picture(opened));
        assertEquals(saved.material().substance(), opened.material().substance());
        assertEquals(saved.terms(), opened.terms());
        assertEquals(saved.camera(), opened.camera());
        assertEquals(saved.zoom(), opened.zoom());
        assertTrue(model.saved().orElseThrow().holds(opened), "the commands are not known");
        model.history().undo();
        assertEquals(before, model.state().choice());
    }

    private void open(Path file) {
        model.open(file);
        thread.settle(model::settle);
    }

    private static int[] picture(LightChoice choice) {
        try (var renderer = new Renderer()) {
            return renderer.render(
                            LitScene.request(
                                    choice, choice.body().scene(), ShadingMethod.PHONG, 120, 90),
                            () -> false)
                    .argb();
        }
    }

    @Test
    @DisplayName("a scene by name loses its detail, or the lamps of the lab")
    void opensScenesByName() throws IOException {
        LightChoice before = model.state().choice();
        open(written("\"torus\", \"detail\": 20"));
        assertEquals(new LitBody("torus", 20, LitBody.OWN), model.state().choice().body());
        assertEquals(before.lamps(), model.state().choice().lamps());
        assertEquals("", model.state().problem());
        open(written("\"house\", \"zoom\": 2, \"look\": {\"terms\": [\"diffuse\"]}"));
        assertEquals("one.scene.json", model.state().choice().body().name());
        assertEquals(2, model.state().choice().zoom());
        assertEquals(Set.of(LightTerm.DIFFUSE), model.state().choice().terms());
        assertFalse(model.saved().isPresent(), "the commands would draw other lamps");
        assertEquals(LightChoice.first().body(), model.kept().light().body());
    }

    @ParameterizedTest(name = "a file is refused for a zoom that the lab has not: {0}")
    @CsvSource({"16, 8", "0.1, 0.25"})
    void cutsTheZoomToItsOwn(double said, double shown) throws IOException {
        open(written("\"torus\", \"detail\": 20, \"zoom\": " + said));
        assertEquals("torus", model.state().choice().body().name());
        assertEquals(shown, model.state().choice().zoom());
        String note = "zoom is %s, not the file's %s".formatted(shown, said);
        assertTrue(model.state().problem().endsWith(note), model.state().problem());
    }

    @ParameterizedTest(name = "not said, or in English: {0}")
    @CsvSource(
            quoteCharacter = '`',
            delimiter = '|',
            value = {
                "{ | in 1",
                "{\"version\": 1, \"scene\": \"vase\", \"look\": {\"cull\": \"x\"}} | $.look.cull",
                "{\"version\": 1, \"scene\": \"vase\", \"zoom\": 9} | 9",
                "{\"version\": 1, \"scene\": \"vase\", \"zoom\": 9, \"look\": {\"cull\":"
                        + " \"back\"}} | cull",
                "{\"version\": 1, \"scene\": \"vase\", \"look\": {\"cull\": \"back\","
                        + " \"stereo\": \"anaglyph\"}} | stereo, cull",
                "{\"version\": 1, \"scene\": \"vase\", \"look\": {\"shading\": \"wire\","
                        + " \"hiddenLines\": \"dashed\", \"crease\": 20}} | shading, hiddenLines, crease",
                "{\"version\": 1, \"scene\": \"vase\", \"look\": {\"shading\": \"tone\","
                        + " \"texture\": \"linear\", \"wrap\": \"clamp\", \"environment\": \"replace\"}}"
                        + " | shading, texture, wrap, environment",
                "{\"version\": 1, \"topic\": \"line\", \"input\": {}} | lab run",
            })
    void saysWhatIsNotShown(String text, String part) throws IOException {
        Path file = Files.writeString(folder.resolve("one.scene.json"), text);
        open(file);
        String problem = model.state().problem();
        String said = Complaints.translated(Language.RUSSIAN, problem);
        if (!part.equals("in 1")) assertTrue(said.contains(part), said);
        assertTrue(said.contains(file.toString()), said);
        assertNotEquals(problem, said);
        String words = said.replace(file.toString(), "").replaceAll("(есть|известны) .*|`.*`", "");
        assertFalse(
                Pattern.compile("\\b(the|must|does|not|of|this|its)\\b").matcher(words).find(),
                said);
        model.choose(choice -> choice.withAmbient(0.9));
        assertEquals("", model.state().problem());
    }

    @Test
    @DisplayName("what a file says as the lab draws it anyway is said to be passed over")
    void saysNothingOfWhatIsDrawn() throws IOException {
        open(
                written(
                        """
                        "torus", "detail": 20, "projection": "perspective", "look": {
                         "shading": "gouraud", "texture": "auto", "cull": "none", "outline": false,
                         "hiddenLines": "removed", "crease": 0}
                        """));
        assertEquals("", model.state().problem());
    }

    @Test
    @DisplayName("the lab waits for a pipe")
    void refusesAPipe() throws Exception {
        Path pipe = Pipe.at(folder.resolve("one.scene.json"));
        open(pipe);
        assertEquals(pipe + ": is a device, pipe or socket, not a scene", model.state().problem());
    }

    @ParameterizedTest(name = "light or faces that the lab cannot make are taken: {2}")
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "\"ambient\" : \\[ 0.2 | \"ambient\" : [ 0.75 | lamps",
                "\"alpha\" : 1.0 | \"alpha\" : 0.5 | substance",
                "(?s)\"alpha\" : 1.0(.*\"ambient\" : \\[ )0.2 | \"alpha\" : 0.5$10.75 | both",
            })
    void saysWhichLightOrMaterialStays(String pattern, String replacement, String what)
            throws IOException {
        Path file = folder.resolve("lit.scene.json");
        LitSceneFile.write(
                LightChoice.first()
                        .with(MaterialChoice.of(Substance.RUBY))
                        .withLamps(List.of(Lamp.at(-80, 3, 20))),
                file);
        String text = Files.readString(file);
        String other = text.replaceFirst(pattern, replacement);
        assertNotEquals(text, other);
        Files.writeString(file, other);
        LightChoice before = model.state().choice();
        open(file);
        String problem = model.state().problem();
        LightChoice opened = model.state().choice();
        boolean lamps = !what.equals("substance");
        boolean material = !what.equals("lamps");
        assertEquals(lamps, problem.contains("lights of this lab"), problem);
        assertEquals(material, problem.contains("no substance of this lab"), problem);
        assertEquals(lamps, before.lamps().equals(opened.lamps()));
        assertEquals(material, before.material().equals(opened.material()));
        assertFalse(model.saved().isPresent());
        String said = Complaints.translated(Language.RUSSIAN, problem);
        assertFalse(Pattern.compile("of this lab|its own").matcher(said).find(), said);
    }

    private Path written(String scene) throws IOException {
        return Files.writeString(
                folder.resolve("one.scene.json"), "{\"version\": 1, \"scene\": " + scene + "}");
    }

    private static final String RING = "{\"version\": 1, \"scene\": \"torus\", \"detail\": 100}";

    private void restarted(LightLabModel next) {
        next.restore(model.kept());
        next.keptFile().restore(model.keptFile().kept());
        thread.settle(next::settle);
    }

    @Test
    @DisplayName("the body of a file, or its normals, are gone after a restart")
    void bodyOfAFileComesBack() throws IOException {
        Path file = Files.writeString(folder.resolve("ring.scene.json"), RING);
        model.open(file);
        thread.settle(model::settle);
        model.choose(choice -> choice.with(choice.body().withNormals("angle")).zoomed(1.25));
        try (var next = new LightLabModel(thread, failures::add)) {
            restarted(next);
            LightChoice opened = next.state().choice();
            assertEquals("ring.scene.json", opened.body().name());
            assertEquals("angle", opened.body().normals());
            assertEquals(model.state().choice().zoom(), opened.zoom());
            assertEquals(model.keptFile().kept(), next.keptFile().kept());
            assertFalse(next.history().undoable());
        }
    }

    @Test
    @DisplayName("a scene file that is broken by the next start is not told")
    void bodyOfTheLabStandsForABrokenFile() throws IOException {
        Path file = Files.writeString(folder.resolve("ring.scene.json"), RING);
        model.open(file);
        thread.settle(model::settle);
        Files.writeString(file, "{");
        try (var next = new LightLabModel(thread, failures::add)) {
            restarted(next);
            assertEquals("sphere", next.state().choice().body().name());
            String problem = next.state().problem();
            assertTrue(problem.startsWith(file + ": "), problem);
            assertTrue(problem.endsWith("; the scene sphere is shown instead"), problem);
            assertEquals(LitFile.NONE, next.keptFile().kept());
        }
    }

    @Test
    @DisplayName("a broken file opened meanwhile costs the body that is coming back, unsaid")
    void brokenFileDoesNotStopOneThatComesBack() throws IOException {
        Path file = Files.writeString(folder.resolve("ring.scene.json"), RING);
        model.open(file);
        thread.settle(model::settle);
        Path broken = Files.writeString(folder.resolve("broken.scene.json"), "{");
        try (var next = new LightLabModel(thread, failures::add)) {
            next.restore(model.kept());
            next.keptFile().restore(model.keptFile().kept());
            next.open(broken);
            thread.settle(next::settle);
            thread.settle(next::settle);
            assertEquals("ring.scene.json", next.state().choice().body().name());
            String problem = next.state().problem();
            assertTrue(problem.startsWith(broken + ": "), problem);
        }
    }
}
