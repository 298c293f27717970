package rasterlab.app.canvas;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.Font;
import javax.swing.UIManager;

/**
 * The size of words and signs in pictures: that of labels, unless the picture is so small beside
 * them that they would hide what it shows.
 */
public final class PictureType {
    /** A picture is at least so many sizes of its type high. */
    private static final int HIGH = 16;

    /** A picture is at least so many sizes of its type wide. */
    private static final int WIDE = 28;

    /** No smaller for any picture, if labels are not. */
    private static final float LEAST = 14;

    /** Rulers, rings and buttons, which take room from the picture, grow no further with type. */
    private static final float MOST_GROWN = 2;

    private PictureType() {}

    /** The type for words in a picture of that size in view units. On the event thread. */
    public static Font in(Dimension picture) {
        Font label = UIManager.getFont("Label.font");
        float most = Math.min((float) picture.height / HIGH, (float) picture.width / WIDE);
        return label.deriveFont(Math.min(label.getSize2D(), Math.max(LEAST, most)));
    }

    /**
     * The size of a ruler, ring or button in a picture.
     *
     * @param usual its size beside type of 100 %
     */
    public static int scaled(int usual) {
        return Math.round(scaled((float) usual));
    }

    /** The size of a button's type in a picture. */
    static float grown(Font type) {
        return scaled(type.getSize2D() / UIScale.getUserScaleFactor());
    }

    static float scaled(float usual) {
        return usual * Math.min(MOST_GROWN, UIScale.getUserScaleFactor());
    }
}
