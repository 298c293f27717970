package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Font;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import javax.swing.JComponent;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.language.Language;
import rasterlab.app.shell.settings.Problem;

class ProblemsTest {
    private static final Font FONT = new Font(Font.DIALOG, Font.PLAIN, 12);

    @Test
    @DisplayName("a notice is as wide as its text, or a narrow column")
    void noticeHasLinesOfOneLengthInTheSmallestWindow() {
        String said =
                Problem.of(
                                "labs.oneNotUsed",
                                "/home/student/labs.json",
                                "line",
                                "it is missing",
                                "a")
                        .in(Language.RUSSIAN);
        Component one = paragraphs(said)[0];
        assertTrue(one.getFontMetrics(FONT).stringWidth(said) > 600, "too short to be wrapped");
        assertTrue(one.getWidth() > 400 && one.getWidth() <= 600, one.getWidth() + " px");
        assertEquals(one.getPreferredSize().height, one.getHeight(), "height of the lines");
    }

    @Test
    void problemsAreParagraphsApart() {
        Component[] both = paragraphs("one problem", "another one");
        int line = both[0].getFontMetrics(FONT).getHeight();
        int gap = both[1].getY() - both[0].getY() - both[0].getHeight();
        assertTrue(gap >= line / 3, gap + " px between them");
    }

    @ParameterizedTest(name = "the terminal is told in another language than {0}")
    @EnumSource
    void terminalIsToldInTheLanguageOfTheWindow(Language language) {
        var told = new ByteArrayOutputStream();
        var err = new PrintStream(told, true, StandardCharsets.UTF_8);
        Problem second = Problem.of("window.second");
        var problems = new Problems(err, Language.ENGLISH);
        problems.speak(language);
        problems.accept(second);
        assertEquals(
                "rasterlab: " + second.in(language), told.toString(StandardCharsets.UTF_8).strip());
    }

    private static Component[] paragraphs(String... said) {
        JComponent notices = Problems.notices(List.of(said), FONT);
        notices.setSize(notices.getPreferredSize());
        notices.doLayout();
        return notices.getComponents();
    }
}
