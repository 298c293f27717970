package rasterlab.app.canvas.lab;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.canvas.method.AboutText;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.mine.OwnMethods;

/** A stage whose picture is of an input before, while the user's program works on another. */
class AwaitedStageTest {
    private static final int SIDE = 300;

    private final JComponent stage =
            new JComponent() {
                private static final long serialVersionUID = 1L;

                @Override
                protected void paintComponent(Graphics g) {
                    g.setColor(Color.RED);
                    g.fillRect(0, 0, getWidth(), getHeight());
                }
            };

    private JPanel lab(StageGuide guide) {
        var lab = new JPanel(null);
        guide.setBounds(0, 0, SIDE, SIDE);
        lab.setSize(SIDE, SIDE);
        lab.add(guide);
        guide.doLayout();
        return lab;
    }

    private StageGuide guide(Language language) {
        return new StageGuide(stage, Texts.of("canvas", language), Optional.empty());
    }

    private static Component veil(StageGuide guide) {
        return Stream.of(guide.getComponents())
                .filter(each -> "awaited".equals(each.getName()))
                .findFirst()
                .orElseThrow();
    }

    private static int corner(JPanel lab) {
        var image = new BufferedImage(SIDE, SIDE, BufferedImage.TYPE_INT_RGB);
        Graphics g = image.createGraphics();
        lab.paint(g);
        g.dispose();
        return image.getRGB(2, 2) & 0xFFFFFF;
    }

    @Test
    void itsPictureIsDimmedUntilTheAnswerIsThere() {
        StageGuide guide = guide(Language.ENGLISH);
        JPanel lab = lab(guide);
        assertEquals(0xFF0000, corner(lab));
        StageGuide.await(lab, true);
        assertNotEquals(0xFF0000, corner(lab));
        StageGuide.await(lab, false);
        assertEquals(0xFF0000, corner(lab));
    }

    @ParameterizedTest
    @EnumSource(Language.class)
    void aSentenceSaysWhatIsWaitedFor(Language language) {
        StageGuide guide = guide(language);
        StageGuide.await(lab(guide), true);
        String said = veil(guide).getAccessibleContext().getAccessibleName();
        assertEquals(Texts.of("canvas", language).text("awaited"), said);
        assertTrue(veil(guide).isVisible());
        assertFalse(said.isBlank());
    }

    @Test
    void theMouseDragsOnWhatIsBelow() {
        StageGuide guide = guide(Language.ENGLISH);
        JPanel lab = lab(guide);
        StageGuide.await(lab, true);
        assertSame(stage, SwingUtilities.getDeepestComponentAt(lab, 150, 150));
    }

    @Test
    void whatWasSaidToTheInputBeforeIsNotSaidMeanwhile() {
        var about = new AboutText("about", Language.ENGLISH);
        var lab = new JPanel();
        lab.add(about);
        about.show(Texts.of("canvas", Language.ENGLISH), OwnMethods.NAME, "", "It was stopped");
        StageGuide.await(lab, true);
        assertFalse(about.getText().contains("It was stopped"), about.getText());
        StageGuide.await(lab, false);
        assertTrue(about.getText().contains("It was stopped"), about.getText());
    }
}
