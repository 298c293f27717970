package rasterlab.app.shell.labs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.awt.EventQueue;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.clip.scene.ClipMode;
import rasterlab.app.coordinates.figure.CoordinatesMode;
import rasterlab.app.language.Language;
import rasterlab.app.line.LineChoice;
import rasterlab.app.line.trace.LineMode;
import rasterlab.app.opengl.state.Setting;
import rasterlab.app.outcome.Pipe;
import rasterlab.app.polygon.figure.PolygonMode;
import rasterlab.app.row.RowLabModel;
import rasterlab.app.shell.OffscreenPainter;
import rasterlab.app.spline.CurveForm;
import rasterlab.app.spline.CurveLabModel;
import rasterlab.app.spline.FunctionLabModel;
import rasterlab.app.spline.SplineMode;
import rasterlab.contract.SplineEnds;
import rasterlab.engine.line.Segment;

@Tag("slow")
class LabsFileTest {
    /** The kept state of files that the user opened. */
    private static final Set<String> OF_FILES =
            Set.of("visibility.files", "light.file", "opengl.image");

    @TempDir Path folder;
    private final List<String> problems = new ArrayList<>();
    private final List<Throwable> failures = new ArrayList<>();

    @Test
    void everyLabOpensAsItWasLeft() throws InterruptedException {
        Map<String, Object> first = shown(models -> {}, false);
        Map<String, Object> left = shown(LabsFileTest::changeAll, false);
        Map<String, Object> opened = shown(models -> {}, true);
        assertEquals(left, opened);
        left.keySet().removeAll(OF_FILES);
        left.forEach((name, choice) -> assertNotEquals(first.get(name), choice, name));
        assertEquals(List.of(), problems);
    }

    @Test
    @DisplayName("a scene or an image of the user's is forgotten at the next start")
    void openedFilesAreOpenedAgain() throws IOException, InterruptedException {
        Path scene =
                Files.writeString(
                        folder.resolve("ring.scene.json"),
                        "{\"version\": 1, \"scene\": \"torus\", \"detail\": 100}");
        Path image = folder.resolve("a flag №1.png");
        ImageIO.write(new BufferedImage(4, 2, BufferedImage.TYPE_INT_RGB), "png", image.toFile());
        Map<String, Object> first = shown(models -> {}, false);
        var left = new TreeMap<String, Object>();
        settled(
                models -> {
                    MadeLabs.visibility(models).open(scene);
                    MadeLabs.light(models).open(scene);
                    MadeLabs.opengl(models).open(image);
                },
                models -> {
                    left.putAll(choices(models));
                    save(models);
                });
        for (String name : OF_FILES) assertNotEquals(first.get(name), left.get(name), name);
        settled(
                models -> {
                    load(file(), models);
                    assertEquals(left, choices(models), "before the files are read");
                },
                models -> {
                    assertEquals(left, choices(models));
                    assertEquals(scene.getFileName().toString(), shownScene(models));
                });
        assertEquals(List.of(), problems);
        assertEquals(List.of(), failures);
    }

    private static String shownScene(LabModels models) {
        return MadeLabs.visibility(models).state().choice().scene();
    }

    private void settled(Consumer<LabModels> before, Consumer<LabModels> after)
            throws InterruptedException {
        var thread = new ModelThread();
        try (LabModels models = LabModels.first(thread, failures::add)) {
            before.accept(models);
            thread.settle(MadeLabs.visibility(models)::settle);
            thread.settle(MadeLabs.light(models)::settle);
            thread.settle(MadeLabs.opengl(models)::settle);
            after.accept(models);
        }
    }

    /** Scenes with NaN, infinities and repeated points among them. */
    @Test
    void everyHazardCanBeKept() throws InterruptedException {
        OffscreenPainter.onEventThread(
                () -> {
                    for (ClipMode mode : ClipMode.values())
                        assertEachKept(
                                MadeLabs::clip,
                                clip -> clip.hazards(mode),
                                (clip, each) -> clip.show(mode, each.name()));
                    for (PolygonMode mode : PolygonMode.values())
                        assertEachKept(
                                MadeLabs::polygon,
                                polygon -> polygon.hazards(mode),
                                (polygon, each) -> polygon.show(mode, each.name()));
                    assertEachRowKept(models -> MadeLabs.visibility(models).rows());
                    assertEachRowKept(models -> MadeLabs.light(models).rows());
                    assertEachKept(
                            models -> MadeLabs.spline(models).curve(),
                            CurveLabModel::hazards,
                            (curve, each) -> curve.show(each.input()));
                    assertEachKept(
                            models -> MadeLabs.spline(models).function(),
                            FunctionLabModel::hazards,
                            (function, each) -> function.show(each.input()));
                });
        assertEquals(List.of(), problems);
    }

    private void assertEachRowKept(Function<LabModels, RowLabModel> rows) {
        assertEachKept(
                rows,
                row -> row.hazards().toList(),
                (row, each) -> row.show(each.topic(), each.hazard().name(), ""));
    }

    /** Makes the hazards' own lab only, which takes a tenth of the time that all of them take. */
    private <M, H> void assertEachKept(
            Function<LabModels, M> lab,
            Function<M, List<? extends H>> hazards,
            BiConsumer<M, ? super H> show) {
        try (LabModels models = unmade()) {
            M model = lab.apply(models);
            for (H each : hazards.apply(model)) {
                show.accept(model, each);
                save(models);
                try (LabModels others = unmade()) {
                    lab.apply(others);
                    load(file(), others);
                    assertEquals(choices(models), choices(others));
                }
            }
        }
    }

    private LabModels unmade() {
        return LabModels.unmade(EventQueue::invokeLater, kept -> {}, failures::add);
    }

    @ParameterizedTest(name = "{0}")
    @ValueSource(
            strings = {
                "{\"line\": {\"segment\": 7}}",
                "{\"line\": {\"segment\": null, \"method\": \"dda\", \"comparison\": \"\"}}",
                "{\"line\": {\"segment\": {\"x0\": 1, \"y0\": 2, \"x1\": 3, \"y1\": 4},"
                        + " \"method\": \"magic\", \"comparison\": \"\"}}",
                "{\"line\": ",
                "[]x"
            })
    void brokenPartIsToldAndTheLabOpensAsOnTheFirstRun(String text)
            throws IOException, InterruptedException {
        Files.writeString(folder.resolve("labs.json"), text);
        Map<String, Object> opened = shown(models -> {}, true);
        problems.forEach(problem -> assertTrue(problem.contains("labs.json"), problem));
        assertEquals(1, problems.size(), problems::toString);
        assertEquals(shown(models -> {}, false), opened);
    }

    @Test
    @DisplayName("a broken file is lost by the first writing")
    void brokenFileIsSetAsideBeforeTheFirstWriting() throws Exception {
        Path broken = folder.resolve("labs.json.broken");
        Files.writeString(broken, "an older one");
        Files.writeString(folder.resolve("labs.json"), "{\"line\": ");
        shown(models -> {}, true);
        shown(models -> {}, false);
        assertEquals("{\"line\": ", Files.readString(broken));
        assertEquals(1, problems.size(), problems::toString);
        assertTrue(problems.get(0).contains(broken.toString()), problems::toString);
        Files.writeString(folder.resolve("labs.json"), "[7]");
        shown(models -> {}, false);
        assertEquals("[7]", Files.readString(broken), "broken since it was read");
    }

    @Test
    @DisplayName("a broken file that cannot be set aside is written over")
    void brokenFileThatCannotBeSetAsideStays() throws IOException {
        Files.createDirectories(folder.resolve("labs.json.broken").resolve("in the way"));
        Path place = Files.writeString(folder.resolve("labs.json"), "[7]");
        LabsFile file = file();
        assertTrue(file.read().isEmpty());
        assertFalse(file.save(Map.of("line", "kept"), Set.of("line")));
        assertEquals("[7]", Files.readString(place));
        assertEquals(1, problems.size(), problems::toString);
        assertTrue(problems.get(0).contains("will not be kept"), problems::toString);
    }

    @Test
    @DisplayName("a part that cannot be used is lost by the first writing")
    void fileWithABrokenPartIsCopiedBeforeTheFirstWriting() throws Exception {
        String text = "{\"line\": {\"segment\": 1e309}}";
        Path place = Files.writeString(folder.resolve("labs.json"), text);
        Path copy = folder.resolve("labs.json.broken");
        shown(models -> {}, true);
        assertEquals(text, Files.readString(copy));
        assertEquals(text, Files.readString(place), "the other parts are still to be read");
        shown(models -> {}, false);
        assertEquals(text, Files.readString(copy));
        assertEquals(1, problems.size(), problems::toString);
        assertTrue(problems.get(0).contains(copy.toString()), problems::toString);
    }

    @Test
    @DisplayName("a part that cannot be used is written over though it cannot be copied")
    void brokenPartThatCannotBeCopiedStays() throws Exception {
        Files.createDirectories(folder.resolve("labs.json.broken").resolve("in the way"));
        Path place = Files.writeString(folder.resolve("labs.json"), "{\"line\": 7, \"clip\": 8}");
        LabsFile file = file();
        OffscreenPainter.onEventThread(
                () -> {
                    try (LabModels models = LabModels.first(failures::add)) {
                        Map<String, Kept<?>> line = Map.of("line", MadeLabs.line(models));
                        file.read().ifPresent(left -> file.restore(left, line));
                    }
                });
        assertTrue(file.save(Map.of("line", "new", "clip", "new"), Set.of("line", "clip")));
        var mapper = new ObjectMapper();
        assertEquals(
                mapper.readTree("{\"line\": 7, \"clip\": \"new\"}"),
                mapper.readTree(place.toFile()));
        assertEquals(1, problems.size(), problems::toString);
        assertTrue(problems.get(0).contains("will not be kept"), problems::toString);
    }

    @Test
    void whatAnOlderVersionDidNotKeepIsAsOnTheFirstRun() throws Exception {
        Map<String, Object> left = shown(LabsFileTest::changeAll, false);
        var mapper = new ObjectMapper();
        var root = (ObjectNode) mapper.readTree(folder.resolve("labs.json").toFile());
        ((ObjectNode) root.path("coordinates.transformations")).remove("trial");
        var line = (ObjectNode) root.path("line");
        line.remove("method");
        ((ObjectNode) line.path("segment")).remove("window");
        ((ObjectNode) root.path("light")).remove(List.of("colours", "colour"));
        mapper.writeValue(folder.resolve("labs.json").toFile(), root);
        Map<String, Object> opened = shown(models -> {}, true);
        assertEquals(List.of(), problems);
        LineChoice whole = (LineChoice) left.remove("line");
        assertEquals(
                new LineChoice(whole.segment(), "bresenham", whole.comparison()),
                opened.remove("line"));
        assertEquals(left, opened);
    }

    @Test
    void pipeStopsNoWindow() throws Exception {
        Pipe.at(folder.resolve("labs.json"));
        shown(models -> {}, true);
        assertTrue(problems.get(0).contains("is a device, pipe or socket"), problems::toString);
    }

    @Test
    @DisplayName("broken JSON is told without its place, or half in English")
    void brokenJsonIsToldInTheWindowsLanguage() throws IOException, InterruptedException {
        String said = russian("{\n\"line\" 7}");
        assertTrue(
                said.contains(
                        "это не JSON: строка 2, столбец 8: здесь допустимо: двоеточие после имени"
                                + " поля, получено «7»"),
                said);
        said = russian("{\"line\": {\"segment\": {\"x0\": \"one\"}}}");
        assertTrue(said.contains("нет «segment.x0», или там не то, что нужно."), said);
        said = russian("7");
        assertTrue(said.contains("это не объект JSON"), said);
    }

    private String russian(String text) throws IOException, InterruptedException {
        Files.writeString(folder.resolve("labs.json"), text);
        var told = new ArrayList<String>();
        OffscreenPainter.onEventThread(
                () -> {
                    try (LabModels models = LabModels.first(failures::add)) {
                        load(
                                LabsFile.nextTo(
                                        folder.resolve("window.properties"),
                                        problem -> told.add(problem.in(Language.RUSSIAN))),
                                models);
                    }
                });
        return told.get(0);
    }

    @Test
    void brokenPartLeavesTheOtherLabsAsTheyWere() throws IOException, InterruptedException {
        Map<String, Object> left = shown(LabsFileTest::changeAll, false);
        Path file = folder.resolve("labs.json");
        Files.writeString(
                file, Files.readString(file).replace("\"dda\"", "\"a method of another time\""));
        Map<String, Object> opened = shown(models -> {}, true);
        assertNotEquals(left.remove("line"), opened.remove("line"));
        assertEquals(left, opened);
        assertTrue(problems.get(0).contains("another time"), problems::toString);
    }

    private static void changeAll(LabModels models) {
        MadeLabs.coordinates(models).show(CoordinatesMode.ROTATION);
        MadeLabs.coordinates(models).views().turnBy(10, 5);
        MadeLabs.coordinates(models).transformations().turnBy(10, 5);
        MadeLabs.coordinates(models).stack().clear();
        MadeLabs.coordinates(models).rotation().turnBy(7);
        MadeLabs.coordinates(models).meeting().chooseMethod("unrounded");
        MadeLabs.polygon(models).show(PolygonMode.TRIANGLE, "past-2-15");
        MadeLabs.line(models)
                .showTried(new Segment(-7, 3, 2_000_000_000, 4), "bresenham", Optional.empty());
        MadeLabs.line(models).chooseMethod("dda");
        MadeLabs.line(models).chooseMode(LineMode.PEN);
        MadeLabs.line(models).figures().move("point.1", 7, 9);
        MadeLabs.line(models).chooseMode(LineMode.ELLIPSE);
        MadeLabs.clip(models).chooseMode(ClipMode.VOLUME);
        MadeLabs.visibility(models).turn(0.1, 0.2);
        MadeLabs.visibility(models).rows().show("depth-buffer", "crossing", "z24");
        MadeLabs.light(models).drawNormals(true);
        MadeLabs.light(models).rows().show("texture-filter", "turned", "linear");
        MadeLabs.opengl(models).set(Setting.SCENE, "globe");
        models.study().choose("triangulate");
        models.exercises().growType(3);
        MadeLabs.spline(models).show(SplineMode.FUNCTION);
        MadeLabs.spline(models).curve().chooseForm(CurveForm.PIECES);
        MadeLabs.spline(models).function().chooseEnds(SplineEnds.slopes(-1.25, 3));
    }

    /** The states of the labs, after loading or before saving. */
    private Map<String, Object> shown(Consumer<LabModels> prepare, boolean load)
            throws InterruptedException {
        var found = new TreeMap<String, Object>();
        OffscreenPainter.onEventThread(
                () -> {
                    try (LabModels models = LabModels.first(failures::add)) {
                        if (load) load(file(), models);
                        prepare.accept(models);
                        found.putAll(choices(models));
                        if (!load) save(models);
                    }
                });
        return found;
    }

    private static Map<String, Object> choices(LabModels models) {
        var found = new TreeMap<String, Object>();
        for (Map.Entry<String, Kept<?>> each : models.kept().entrySet())
            found.put(each.getKey(), each.getValue().kept());
        return found;
    }

    private static void load(LabsFile file, LabModels models) {
        file.read().ifPresent(content -> file.restore(content, models.kept()));
    }

    private void save(LabModels models) {
        Map<String, Object> choices = LabsFile.choices(models);
        assertTrue(file().save(choices, choices.keySet()));
    }

    private LabsFile file() {
        return LabsFile.nextTo(
                folder.resolve("window.properties"), problem -> problems.add(problem.toString()));
    }
}
