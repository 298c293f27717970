package rasterlab.app.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.regex.Pattern;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.cli.Lab;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Language;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.Pipe;
import rasterlab.app.visibility.scene.SceneFiles;
import rasterlab.app.visibility.scene.VisibilityChoice;

/** Reads what the lab says in Russian of files that are broken. */
@Tag("slow")
class FileComplaintsTest {
    /** Words that an English sentence of a reader has. */
    private static final Pattern ENGLISH =
            Pattern.compile(
                    "\\b(a|the|must|needs?|got|is|are|was|to|at most|from|there|no|not|and|only)\\b");

    private static final long SEED = 20261122;

    /** One for each thing that the parser says. */
    private static final List<String> BROKEN_JSON =
            List.of(
                    "// x",
                    "[1.]",
                    "[1e]",
                    "[-]",
                    "[+1]",
                    "[nan]",
                    "{\"a\" 1}",
                    "[1 2]",
                    "[\"\\q\"]",
                    "[\"\\u00g1\"]",
                    "[\"a\nb\"]",
                    "{} x",
                    "{}}",
                    "[}",
                    "{]",
                    "[tru]",
                    "[1]2",
                    "[\u0000]",
                    "[" + "9".repeat(2000) + "]",
                    "[".repeat(2000));

    @TempDir Path folder;

    @ParameterizedTest(name = "the reason is told in English: {0}, {1}")
    @CsvSource(
            quoteCharacter = '`',
            delimiter = '|',
            value = {
                "one.scene.json | {",
                "one.scene.json | {\"version\": 1,, }",
                "one.scene.json | {\"version\": 1, \"version\": 1}",
                "one.scene.json | []",
                "one.scene.json | {}",
                "one.scene.json | {\"version\": 1, \"scene\": 7}",
                "one.scene.json | {\"version\": 1, \"scene\": {\"name\": \"n\", \"faces\": [{}], \"finishes\": []}}",
                "one.scene.json | {\"version\": 7}",
                "one.scene.json | {\"version\": 1, \"colour\": 3}",
                "one.scene.json | {\"version\": 1, \"scene\": \"castle\"}",
                "one.scene.json | {\"version\": 1, \"scene\": \"vase\", \"projection\": \"round\"}",
                "one.scene.json | {\"version\": 1, \"scene\": \"vase\", \"look\": {\"shading\": \"x\"}}",
                "one.scene.json | {\"version\": 1, \"scene\": \"vase\", \"look\": {\"texture\": \"x\"}}",
                "one.scene.json | {\"version\": 1, \"scene\": \"vase\", \"look\": {\"visibility\": \"x\"}}",
                "one.scene.json | {\"version\": 1, \"scene\": \"vase\", \"camera\": {\"theta\": \"x\"}}",
                "one.scene.json | {\"version\": 1, \"scene\": \"vase\", \"zoom\": 0}",
                "one.scene.json | {\"version\": 1, \"scene\": \"vase\", \"near\": 7, \"far\": 5}",
                "one.scene.json | {\"version\": 1, \"scene\": \"vase\", \"near\": -7}",
                "one.scene.json | {\"version\": 1, \"scene\": \"vase\", \"zoom\": 100}",
                "one.scene.json | {\"version\": 1, \"scene\": \"vase\", \"clipPlanes\": [[0, 0, 0, 1]]}",
                "one.scene.json | {\"version\": 1, \"scene\": \"vase\", \"clipPlanes\": [[1,0,0,1],[1,0,0,1],[1,0,0,1],[1,0,0,1],[1,0,0,1],[1,0,0,1],[1,0,0,1]]}",
                "one.scene.json | {\"version\": 1, \"scene\": \"vase\", \"look\": {\"wrap\": \"x\"}}",
                "one.scene.json | {\"version\": 1, \"scene\": \"vase\", \"look\": {\"environment\": \"x\"}}",
                "one.scene.json | {\"version\": 1, \"scene\": \"vase\", \"look\": {\"terms\": [\"x\"]}}",
                "one.scene.json | {\"version\": 1, \"scene\": \"vase\", \"look\": {\"terms\": [\"diffuse\", \"diffuse\"]}}",
                "one.scene.json | {\"version\": 1, \"scene\": \"vase\", \"look\": {\"twoSided\": 2}}",
                "one.scene.json | {\"version\": 1, \"scene\": \"vase\", \"look\": {\"cull\": \"x\"}}",
                "one.scene.json | {\"version\": 1, \"scene\": \"vase\", \"look\": {\"hiddenLines\": \"x\"}}",
                "one.scene.json | {\"version\": 1, \"scene\": \"vase\", \"look\": {\"crease\": 200}}",
                "one.scene.json | {\"version\": 1, \"scene\": \"vase\", \"look\": {\"depthCue\": 0}}",
                "one.scene.json | {\"version\": 1, \"scene\": \"vase\", \"look\": {\"stereo\": \"x\"}}",
                "one.scene.json | {\"version\": 1, \"scene\": \"vase\", \"look\": {\"textureImage\": \"gone.png\"}}",
                "one.scene.json | {\"version\": 1, \"scene\": \"vase\", \"look\": {\"textureImage\": \"../up.png\"}}",
                "one.scene.json | {\"version\": 1, \"scene\": {\"name\": \"\"}}",
                "one.scene.json | {\"version\": 1, \"scene\": {\"name\": \"n\", \"vertices\": [[1, 2]]}}",
                "one.obj | f 1 2 3",
                "one.obj | v 1 2",
                "one.obj | v 1 2 x",
                "one.obj | v 1 2 3 4 5",
                "one.obj | f 1 2",
                "one.obj | curv 1 2",
                "one.obj | vn 0 0 0",
                "one.obj | s maybe",
                "one.obj | usemtl gold",
                "one.obj | mtllib gone.mtl",
                "one.obj | # nothing",
                "one.obj | Hello, world",
                "one.png | no picture",
                "one.gif | no picture",
            })
    void brokenFileIsToldInRussian(String name, String content) throws IOException {
        Path file = Files.writeString(folder.resolve(name), content);
        SceneFiles.SceneAnswer answer = SceneFiles.read(file);
        assertRussian(answer.problem().isEmpty() ? refusal(answer) : answer.problem());
    }

    @ParameterizedTest(
            name = "an empty file, or a number or picture of no use, is told in English: {0}")
    @ValueSource(
            strings = {
                "",
                "{\"version\": 01}",
                "{\"version\": NaN}",
                "{\"version\": 1, \"scene\": \"vase\", \"zoom\": -Infinity}",
                "{\"version\": 1, \"scene\": \"vase\", \"camera\": {\"theta\": 1e308, \"phi\": 1, \"rho\": 9}}",
                "{\"version\": 1, \"scene\": \"vase\", \"look\": {\"textureImage\": \".\"}}",
                "{\"version\": 1, \"scene\": \"house\", \"look\": {\"textureImage\": \"one.scene.json\"}}",
            })
    void contentOfNoUseIsToldInRussian(String content) throws IOException {
        brokenFileIsToldInRussian("one.scene.json", content);
    }

    /** The parts of a readable file that the lab cannot show. */
    private static String refusal(SceneFiles.SceneAnswer answer) {
        return assertThrows(
                        IllegalArgumentException.class,
                        () -> answer.change().apply(VisibilityChoice.first()))
                .getMessage();
    }

    @Test
    @DisplayName("a file that is not there, or cannot be written, is told in English")
    void fileOfNoUseIsToldInRussian() throws IOException {
        for (String name : new String[] {"none.obj", "none.scene.json", "none.png"})
            assertRussian(SceneFiles.read(folder.resolve(name)).problem());
        Path inNoFolder = folder.resolve("gone").resolve("one.scene.json");
        assertRussian(
                assertThrows(
                                Complaint.class,
                                () -> SceneFiles.save(inNoFolder, VisibilityChoice.first()))
                        .getMessage());
        byte[] half = new byte[60];
        byte[] signature = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
        System.arraycopy(signature, 0, half, 0, signature.length);
        Path broken = Files.write(folder.resolve("half.png"), half);
        String said = SceneFiles.read(broken).problem();
        assertTrue(Complaints.translated(Language.RUSSIAN, said).contains("изображение"), said);
        for (String name : new String[] {"half.scene.json", "half.obj"}) {
            Path picture = Files.write(folder.resolve(name), half);
            String refused = SceneFiles.read(picture).problem();
            assertTrue(refused.contains("looks like a PNG picture"), refused);
            assertRussian(refused);
        }
        Path notText = folder.resolve("latin.scene.json");
        Files.write(notText, "\u00e9".getBytes(StandardCharsets.ISO_8859_1));
        assertRussian(SceneFiles.read(notText).problem());
    }

    /** Damage of one sign or two, and what the parser says of each kind of it. */
    @Test
    @DisplayName("a place that is not JSON is told without line and column, or half in English")
    void brokenJsonIsToldInRussian() throws IOException {
        List<String> texts = new ArrayList<>(BROKEN_JSON);
        var random = new Random(SEED);
        String signs = "0123456789-+.eE{}[]\",: \\\ntrufals\u00e9\u0000'/#NaI";
        for (int round = 0; round < 1000; round++) {
            var damaged =
                    new StringBuilder("{\"version\": 1, \"scene\": \"vase\", \"near\": -0.5e3}");
            for (int times = random.nextInt(2); times >= 0; times--)
                damaged.setCharAt(
                        random.nextInt(damaged.length()),
                        signs.charAt(random.nextInt(signs.length())));
            texts.add(damaged.toString());
        }
        for (String text : texts) {
            Path file = Files.writeString(folder.resolve("one.scene.json"), text);
            String problem = SceneFiles.read(file).problem();
            if (problem.contains("not JSON")) assertRussianPlace(file, problem);
        }
    }

    private static void assertRussianPlace(Path file, String problem) {
        String said = Complaints.translated(Language.RUSSIAN, problem).replace(file.toString(), "");
        String words = said.replaceAll("(?s)«.*?»|true|false|null|JSON", "");
        assertFalse(
                Pattern.compile("[A-Za-z]{2}").matcher(words).find(),
                "seed " + SEED + ": " + problem + " → " + said);
        assertTrue(
                problem.contains("exceeds") || said.contains("строка ") && said.contains("столбец"),
                said);
    }

    @Test
    @DisplayName("the lab waits for a pipe")
    void pipeIsToldInRussian() throws Exception {
        for (String name : new String[] {"one.obj", "one.scene.json", "one.png"}) {
            Path pipe = Pipe.at(folder.resolve(name));
            SceneFiles.SceneAnswer answer = SceneFiles.read(pipe);
            assertRussian(answer.problem());
            assertTrue(answer.problem().contains("pipe"), answer.problem());
        }
    }

    @ParameterizedTest(name = "the lab names {0} otherwise than the command")
    @ValueSource(strings = {"gone.png", "../up.png", "text.png", ".", "one.scene.json"})
    void pictureIsNamedAsTheCommandNamesIt(String image) throws IOException {
        Files.writeString(folder.resolve("text.png"), "no picture");
        Path file =
                Files.writeString(
                        folder.resolve("one.scene.json"),
                        "{\"version\": 1, \"scene\": \"torus\", \"look\": {\"textureImage\": \"%s\"}}"
                                .formatted(image));
        var err = new ByteArrayOutputStream();
        Lab.run(
                new String[] {"render", file.toString(), "--out", folder + "/out.png"},
                InputStream.nullInputStream(),
                new PrintStream(OutputStream.nullOutputStream()),
                new PrintStream(err));
        String problem = SceneFiles.read(file).problem();
        assertEquals("./lab render: " + problem, err.toString(StandardCharsets.UTF_8).strip());
        assertTrue(problem.startsWith(file + ": $.look.textureImage: "), problem);
    }

    private void assertRussian(String problem) {
        assertFalse(problem.isEmpty(), "nothing is wrong with the file");
        String said = Complaints.translated(Language.RUSSIAN, problem);
        String words = said.replace(folder.toString(), "").replaceAll("(есть|известны) .*", "");
        assertFalse(ENGLISH.matcher(words).find(), problem + " → " + said);
        assertTrue(said.contains(folder.toString()), said);
    }
}
