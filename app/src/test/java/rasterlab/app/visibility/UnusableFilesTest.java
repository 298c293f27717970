package rasterlab.app.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Language;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.visibility.scene.VisibilityChoice;
import rasterlab.engine.pipeline.Renderer;

/** Files of any kind that are opened or dropped: what is wrong is told, and nothing is lost. */
@Tag("slow")
class UnusableFilesTest {
    private static final String PNG = "\u0089PNG\r\n\u001a\n rest";
    private static final String KINDS = "unknown extension; allowed are .obj, .scene.json, .png";

    @TempDir Path folder;

    static Stream<Arguments> files() {
        return Stream.of(
                argumentSet("source", "Line.java", "class Line {}", KINDS),
                argumentSet("picture named .json", "a.json", PNG, KINDS),
                argumentSet("file without an ending", "scene", "{}", KINDS),
                argumentSet(
                        "picture named .scene.json",
                        "a.scene.json",
                        PNG,
                        "looks like a PNG picture, not a scene"),
                argumentSet(
                        "scene named .png",
                        "scene.png",
                        "{ \"scene\": ",
                        "is not a picture that can be read"),
                argumentSet("cut picture", "a.png", PNG, "the picture is cut off"),
                argumentSet("binary scene", "b.scene.json", "\u00ff\u00fe\u0000\u0001", "UTF-8"),
                argumentSet("binary model", "b.obj", "\u0001\u0002\u00ff\n\u0003", "b.obj"),
                argumentSet("empty scene", "c.scene.json", "", "the file is empty"),
                argumentSet(
                        "empty model",
                        "c.obj",
                        "",
                        "no face with an area, no line and no point is in it"));
    }

    @ParameterizedTest(name = "{argumentSetName} is opened, thrown or not told")
    @MethodSource("files")
    void isNamedWithWhatIsAllowed(String name, String text, String said) throws Exception {
        Path file = folder.resolve(name);
        Files.write(file, text.getBytes(StandardCharsets.ISO_8859_1));
        assertRefused(file, said);
    }

    @ParameterizedTest(name = "{0} is opened, thrown or not told")
    @MethodSource("folders")
    void folderIsNamed(String name) throws Exception {
        assertRefused(Files.createDirectory(folder.resolve(name)), "is a folder, not ");
    }

    static List<String> folders() {
        return List.of("folder", "folder.obj", "folder.scene.json", "folder.png");
    }

    private static void assertRefused(Path file, String said) throws Exception {
        var thread = new ModelThread();
        var failures = new CopyOnWriteArrayList<Throwable>();
        try (var model =
                new VisibilityLabModel(
                        new OwnMethods(), new Renderer()::render, thread, failures::add)) {
            model.resize(20, 20);
            VisibilityChoice before = model.state().choice();
            model.open(file);
            thread.settle(model::settle);
            String problem = model.state().problem();
            assertTrue(problem.contains(said), problem);
            assertTrue(problem.contains(file.toString()), problem);
            assertEquals(before, model.state().choice());
            assertFalse(model.history().undoable());
            String russian = Complaints.translated(Language.RUSSIAN, problem);
            assertTrue(Pattern.compile("[а-яё]{3}").matcher(russian).find(), russian);
        }
        assertEquals(List.of(), failures);
    }
}
