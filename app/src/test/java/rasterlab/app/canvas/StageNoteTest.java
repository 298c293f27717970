package rasterlab.app.canvas;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Font;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class StageNoteTest {
    private static final String LONG = "A note that is long. ".repeat(12).strip();

    private static final Rectangle INSIDE = new Rectangle(40, 20, 380, 480);

    private static StageNote note(String sentence) {
        return new StageNote(sentence, INSIDE, new Font(Font.DIALOG, Font.PLAIN, 18));
    }

    /** The lowest row that the sentence paints. */
    private static int painted(String sentence) {
        var image = new BufferedImage(420, 500, BufferedImage.TYPE_INT_ARGB);
        var g = image.createGraphics();
        note(sentence).paint(g, StageColors.LIGHT);
        g.dispose();
        int last = 0;
        for (int y = 0; y < 500; y++)
            for (int x = 0; x < 420; x++) if (image.getRGB(x, y) != 0) last = y;
        return last;
    }

    /** The lines that the sentence is painted as, as one. */
    private static String written(String sentence) {
        String svg =
                SvgPicture.of(420, 500, g -> note(sentence).paint(g, StageColors.LIGHT)).document();
        return Pattern.compile("<text[^>]*>([^<]*)</text", Pattern.DOTALL)
                .matcher(svg)
                .results()
                .map(line -> line.group(1))
                .collect(Collectors.joining(" "));
    }

    @Test
    void whatIsWrittenAfterTheSentenceHasTheFontFromBefore() {
        var image = new BufferedImage(420, 500, BufferedImage.TYPE_INT_ARGB);
        var g = image.createGraphics();
        Font before = g.getFont();
        note(LONG).paint(g, StageColors.LIGHT);
        assertEquals(before, g.getFont());
        g.dispose();
    }

    @ParameterizedTest(name = "the picture begins above the last line: repeated {0} times")
    @ValueSource(ints = {1, 2, 9})
    void pictureBeginsBelowEveryLineOfTheSentence(int times) {
        String sentence = LONG.repeat(times);
        assertTrue(painted(sentence) > 5 * 18, "too short to be wrapped");
        Rectangle below = note(sentence).below();
        assertTrue(below.y > painted(sentence), below + " of " + painted(sentence));
        assertEquals(500, below.y + below.height);
    }

    @Test
    void sentenceLeavesAtLeastHalf() {
        assertEquals(INSIDE, note("").below());
        for (int times = 1; times < 9; times++)
            assertTrue(note(LONG.repeat(times)).below().height >= 240, times + " times");
    }

    @Test
    void onlyASentenceThatIsTooLongInSmallTypeIsCut() {
        String smaller = LONG + " " + LONG;
        assertEquals(LONG, written(LONG));
        assertEquals(smaller, written(smaller));
        String cut = written(LONG.repeat(9));
        assertTrue(cut.endsWith("…"), cut);
        assertTrue(LONG.repeat(9).startsWith(cut.substring(0, cut.length() - 1)), cut);
    }
}
