package rasterlab.app.outcome;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Language;
import rasterlab.exercises.SourceEncoding;

class TextEncodingTest {
    @TempDir Path folder;

    @ParameterizedTest(name = "{0} is called no UTF-8 only")
    @CsvSource({
        "UTF-16LE, is UTF-16 text, это текст в кодировке UTF-16",
        "UTF-16BE, is UTF-16 text, это текст в кодировке UTF-16",
        "windows-1251, looks like Windows-1251 text, это похоже на текст в кодировке Windows-1251"
    })
    void namesWhatItMet(String charset, String english, String russian) throws IOException {
        Path file =
                Files.write(
                        folder.resolve("a.java"),
                        "class Линия { /* рисует */ }\n".getBytes(Charset.forName(charset)));
        String refusal =
                assertThrows(Complaint.class, () -> FileToRead.text(file, FileKind.SOURCE))
                        .getMessage();
        assertEquals(file + ": " + english + "; " + SourceEncoding.HOW_TO_SAVE, refusal);
        assertEquals(
                file
                        + ": "
                        + russian
                        + "; сохраните его в UTF-8: в VS Code щёлкните кодировку справа внизу и"
                        + " выберите «Сохранить с кодировкой», в IntelliJ IDEA щёлкните её и выберите"
                        + " «Convert», в Блокноте выберите «Сохранить как» и кодировку UTF-8",
                Complaints.translated(Language.RUSSIAN, refusal));
    }

    @ParameterizedTest(name = "{0} is taken for {1}")
    @CsvSource({"ascii, UTF_8", "имя, UTF_8", "'', UTF_8", "a, UTF_8"})
    void leavesUtf8Alone(String text, TextEncoding encoding) {
        assertEquals(encoding, TextEncoding.of(text.getBytes(StandardCharsets.UTF_8)));
    }
}
