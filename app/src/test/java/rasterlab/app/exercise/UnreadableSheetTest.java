package rasterlab.app.exercise;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.exercise.outcome.Notice;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.predicting.SheetText;

@Timeout(300)
class UnreadableSheetTest {
    private static final URI SERVER = URI.create("http://localhost:1");

    @Test
    void whatIsWrongIsToldInTheWindowsLanguage() {
        var exercise = Catalogue.builtIn().named("predict-line");
        String sheet = SheetText.open(exercise, 5).replaceFirst("\"x\": null", "\"x\": \"left\"");
        IOException refused =
                assertThrows(UnreadableSheet.class, () -> UnreadableSheet.check(exercise, sheet));
        Notice notice = ServerNotices.of(SERVER, refused);
        assertEquals(
                "Лист не отправлен: лист, поле «answers[0]», поле «x»: должно быть числом или null,"
                        + " если ответа нет; получено \"left\".",
                notice.in(Texts.of("exercise", Language.RUSSIAN)));
        String english = notice.in(Texts.of("exercise", Language.ENGLISH));
        assertTrue(
                english.endsWith("must be a number, or null for no answer; got \"left\"."),
                english);
    }

    @Test
    void aSheetThatCanBeReadAndAProgramAreLetThrough() throws IOException {
        var exercise = Catalogue.builtIn().named("predict-line");
        UnreadableSheet.check(exercise, SheetText.open(exercise, 5));
        UnreadableSheet.check(exercise, "\uFEFF" + SheetText.open(exercise, 5));
        UnreadableSheet.check(Catalogue.builtIn().named("line-bresenham"), "{");
    }

    @Test
    @Tag("slow")
    void nothingIsSentOfIt(@TempDir Path folder) throws Exception {
        try (var server = SubmittingTest.server();
                var trial = new Trial(folder)) {
            trial.model.enrolment().join(server.address(), "CODE", "Ann");
            trial.awaitEnd();
            trial.model.choose("predict-line");
            trial.model.type("{");
            trial.model.submit();
            Notice notice = trial.awaitEnd().notice();
            assertEquals("sheet", notice.key());
            assertTrue(
                    server.asked.stream().noneMatch(one -> one.path().contains("submissions")),
                    server.asked::toString);
            assertEquals(Optional.empty(), trial.state().outcome());
        }
    }
}
