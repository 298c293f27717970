package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Font;
import java.util.List;
import javax.swing.JComponent;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;

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

    private static Component[] paragraphs(String... said) {
        JComponent notices = Problems.notices(List.of(said), FONT);
        notices.setSize(notices.getPreferredSize());
        notices.doLayout();
        return notices.getComponents();
    }
}
