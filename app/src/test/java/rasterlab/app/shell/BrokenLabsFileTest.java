package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.language.Language;
import rasterlab.app.shell.labs.LabsFile;

/** People may write the labs' file: what is wrong in it is told by its place. */
class BrokenLabsFileTest {
    @TempDir Path folder;

    static Stream<Arguments> broken() {
        return Stream.of(
                argumentSet(
                        "the last of two parts of one name is taken",
                        "{\"line\": 1,\n \"line\": 2}",
                        "not JSON: line 2, column 8: Duplicate field “line”"),
                argumentSet(
                        "what follows is passed over",
                        "{} {}",
                        "not JSON: line 1, column 4: the value ends here, but something follows it"),
                argumentSet("an array is taken", "[]", "not a JSON object"),
                argumentSet(
                        "letters in another encoding become others",
                        "{\"line\": \"\u00e9\"}",
                        "is not UTF-8 text"));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("broken")
    void isSetAsideWithItsReason(String latin, String reason) throws IOException {
        Path file = folder.resolve("labs.json");
        byte[] text = latin.getBytes(StandardCharsets.ISO_8859_1);
        Files.write(file, text);
        List<String> problems = new ArrayList<>();
        var labs = new LabsFile(file, one -> problems.add(one.in(Language.ENGLISH)));
        assertTrue(labs.read().isEmpty());
        assertEquals(1, problems.size());
        assertTrue(problems.get(0).contains(reason), problems.get(0));
        assertArrayEquals(text, Files.readAllBytes(folder.resolve("labs.json.broken")));
    }
}
