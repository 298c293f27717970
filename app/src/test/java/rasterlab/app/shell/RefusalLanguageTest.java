package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.util.Optional;
import java.util.concurrent.ConcurrentLinkedQueue;
import javax.swing.AbstractButton;
import javax.swing.JLabel;
import javax.swing.JTextField;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rasterlab.app.canvas.Parts;
import rasterlab.app.language.Language;
import rasterlab.app.shell.labs.LabModels;
import rasterlab.app.shell.settings.LabLook;
import rasterlab.app.shell.settings.LabTheme;

/** Words of an exercise over a lab, and in place of it, stay when the window's language changes. */
class RefusalLanguageTest {
    private static final String CIRCLE = "{\"center\": [2, -3], \"radius\": 4}";

    private final ConcurrentLinkedQueue<Throwable> failures = new ConcurrentLinkedQueue<>();
    private LabModels models;
    private LabTabs tabs;
    private LabContent content;

    @BeforeEach
    void openInRussian() throws InterruptedException {
        OffscreenPainter.onEventThread(
                () -> {
                    LabTheme.LIGHT.install();
                    models = LabModels.first(failures::add);
                    fill(Language.RUSSIAN);
                });
    }

    @AfterEach
    void close() throws InterruptedException {
        OffscreenPainter.onEventThread(
                () -> {
                    tabs.close();
                    models.close();
                });
        assertTrue(failures.isEmpty(), failures::toString);
    }

    private void fill(Language language) {
        tabs = LabTabs.create(models, language, failures::add);
        var look = LabLook.first(language);
        content = new LabContent(tabs, "line", look, chosen -> {}, chosen -> {});
    }

    /** Makes tabs and content again, as the window does. */
    private void speakEnglish() throws InterruptedException {
        OffscreenPainter.onEventThread(
                () -> {
                    LabTabs before = tabs;
                    before.close();
                    fill(Language.ENGLISH);
                });
        settle();
    }

    private void settle() throws InterruptedException {
        OffscreenPainter.paint(tabs.named("line").panel(), 1200, 760);
    }

    private void does(Runnable work) throws InterruptedException {
        OffscreenPainter.onEventThread(work);
        settle();
    }

    private void press(String name) {
        ((AbstractButton) found(name)).doClick();
    }

    private Component found(String name) {
        return search(content, name).orElseThrow(() -> new AssertionError(name));
    }

    private static Optional<Component> search(Container in, String name) {
        return Parts.shown(in).filter(each -> name.equals(each.getName())).findFirst();
    }

    private String text(String name) {
        Component found = found(name);
        return found instanceof JLabel label ? label.getText() : ((JTextComponent) found).getText();
    }

    /** Offers to hand a segment in over the lab, which shows a circle meanwhile. */
    private void offerLine() throws InterruptedException {
        does(
                () -> {
                    tabs.opening().showToHandIn("break-line", "line", "");
                    tabs.opening().showInput("circle", CIRCLE, "", Optional.empty());
                });
    }

    @Test
    void theOfferToHandInIsMadeInTheOtherLanguage() throws InterruptedException {
        offerLine();
        speakEnglish();
        assertEquals(
                "“Break it: lines of pixels”: change the input here, then submit it",
                text("handIn.for"));
    }

    @Test
    void theRefusalOverALabIsToldInTheOtherLanguage() throws InterruptedException {
        offerLine();
        does(() -> press("handIn"));
        assertEquals(
                "«Найдите ошибки: отрезки»: сейчас в лаборатории нет данных этой темы",
                text("handIn.for"));
        speakEnglish();
        assertEquals(
                "“Break it: lines of pixels”: the lab shows no input of this topic now",
                text("handIn.for"));
    }

    @Test
    void theOfferThatWasClosedStaysAway() throws InterruptedException {
        offerLine();
        does(() -> press("own.close"));
        speakEnglish();
        assertFalse(search(content, "handIn.for").isPresent());
    }

    @Test
    void whatAnAnswerLacksIsToldInTheOtherLanguage() throws InterruptedException {
        does(() -> press("questions"));
        does(
                () -> {
                    ((JTextField) found("practice.x")).setText("1");
                    press("practice.answer");
                });
        assertEquals("Укажите значение: y.", text("practice.why"));
        speakEnglish();
        assertEquals("Give a value for y.", text("practice.why"));
        assertEquals("1", text("practice.x"));
        does(() -> press("practice.newData"));
        assertFalse(search(content, "practice.why").isPresent(), "it is about other data");
    }

    @Test
    void aSeedThatIsNoneIsRefusedInTheOtherLanguage() throws InterruptedException {
        does(() -> press("questions"));
        does(
                () -> {
                    var seed = (JTextField) found("practice.seed");
                    seed.setText("-3");
                    seed.postActionEvent();
                });
        String russian = text("practice.why");
        speakEnglish();
        assertTrue(text("practice.why").contains("seed"), text("practice.why"));
        assertTrue(russian.matches(".*\\p{IsCyrillic}.*"), russian);
    }
}
