package rasterlab.app.exercise.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static rasterlab.app.exercise.ShownResult.named;

import java.awt.Component;
import java.awt.EventQueue;
import java.net.URI;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Stream;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.server.Account;

class JoinFormTest {
    private static final URI SERVER = URI.create("http://localhost:8080");

    @ParameterizedTest(name = "the form does not tell in {0} where ''{1}'' has joined")
    @CsvSource(
            delimiter = '|',
            value = {
                "ENGLISH | Ann | Submissions go to http://localhost:8080, under the name Ann.",
                "ENGLISH | '' | Submissions go to http://localhost:8080.",
                "RUSSIAN | Анна | Решения отправляются на http://localhost:8080 под именем Анна.",
                "RUSSIAN | '' | Решения отправляются на http://localhost:8080."
            })
    void tellsWhereTheStudentHasJoined(Language language, String student, String said)
            throws Exception {
        var account = new Account(SERVER, "secret", student);
        var words = (JTextComponent) joined(language, Optional.of(account));
        assertEquals(said, words.getText());
    }

    @Test
    @DisplayName("one who has joined nothing is told of a server")
    void tellsNothingBefore() throws Exception {
        assertNull(joined(Language.ENGLISH, Optional.empty()));
    }

    @Test
    @DisplayName("a field that is not needed is called like one that is")
    void fieldsThatAreNotNeededLookSo() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    Optional<Account> none = Optional.empty();
                    var form =
                            new JoinForm(
                                    Texts.of("exercise", Language.ENGLISH),
                                    none,
                                    JoinForm.Typed.first(none));
                    assertFalse(isNameEnabled(form, "join.token"));
                    assertTrue(isNameEnabled(form, "join.code"));
                    ((JCheckBox) named(form, "join.known")).doClick();
                    assertTrue(isNameEnabled(form, "join.token"));
                    assertFalse(isNameEnabled(form, "join.code"));
                });
    }

    private static boolean isNameEnabled(JoinForm form, String field) {
        return Stream.of(form.getComponents())
                .filter(JLabel.class::isInstance)
                .filter(label -> ((JLabel) label).getLabelFor() == named(form, field))
                .findFirst()
                .orElseThrow()
                .isEnabled();
    }

    private static Component joined(Language language, Optional<Account> account) throws Exception {
        var found = new AtomicReference<Component>();
        EventQueue.invokeAndWait(
                () -> {
                    var form =
                            new JoinForm(
                                    Texts.of("exercise", language),
                                    account,
                                    JoinForm.Typed.first(account));
                    found.set(named(form, "join.joined"));
                });
        return found.get();
    }
}
