package rasterlab.app.canvas.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.Graphics;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import java.util.HashSet;
import java.util.Set;
import javax.accessibility.AccessibleRole;
import javax.swing.JPanel;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.canvas.SelfDrawn;
import rasterlab.app.canvas.ZoomButtons;
import rasterlab.app.canvas.Zooming;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

class ShownPictureTest {
    private static final int GROUND = Color.WHITE.getRGB();
    private static final int RING = Color.BLUE.getRGB();

    /** A stage that has the keyboard, with the zoom buttons on it. */
    private static JPanel stage() {
        var stage = new JPanel(null);
        stage.setBackground(Color.WHITE);
        stage.setSize(200, 100);
        var buttons = new ZoomButtons(Texts.of("canvas", Language.ENGLISH), stage, new Unmoved());
        buttons.setBounds(80, 50, 120, 40);
        buttons.doLayout();
        var picture = new Picture();
        picture.setBounds(0, 0, 40, 40);
        stage.add(buttons);
        stage.add(picture);
        return stage;
    }

    private static final class Unmoved implements Zooming {
        @Override
        public void zoom(double factor, Point2D view) {}

        @Override
        public void fit() {}
    }

    private static final class Picture extends SelfDrawn {
        private static final long serialVersionUID = 1L;

        Picture() {
            super(AccessibleRole.CANVAS);
        }

        @Override
        public boolean isFocusOwner() {
            return true;
        }

        @Override
        protected void paintComponent(Graphics g) {
            g.setColor(showsFocus() ? Color.BLUE : Color.GREEN);
            g.fillRect(0, 0, getWidth(), getHeight());
        }
    }

    private static Set<Integer> colors(BufferedImage image) {
        var colors = new HashSet<Integer>();
        for (int y = 0; y < image.getHeight(); y++)
            for (int x = 0; x < image.getWidth(); x++) colors.add(image.getRGB(x, y));
        return colors;
    }

    @Test
    @DisplayName("what lies between two pictures is black")
    void placesThatNothingPaintsHaveTheGround() {
        var stage = new JPanel(null);
        stage.setOpaque(false);
        stage.setBackground(Color.WHITE);
        stage.setSize(200, 100);
        assertEquals(Set.of(GROUND), colors(ShownPicture.dotsOf(stage)));
    }

    @Test
    void copiedPictureHasNoButtonsAndNoRing() {
        assertEquals(Set.of(GROUND, Color.GREEN.getRGB()), colors(ShownPicture.dotsOf(stage())));
    }

    @Test
    void screenHasBoth() {
        var image = new BufferedImage(200, 100, BufferedImage.TYPE_INT_RGB);
        stage().paint(image.createGraphics());
        Set<Integer> colors = colors(image);
        assertTrue(colors.contains(RING) && colors.size() > 3, colors.toString());
    }
}
