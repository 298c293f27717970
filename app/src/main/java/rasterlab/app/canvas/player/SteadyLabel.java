package rasterlab.app.canvas.player;

import java.awt.Dimension;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.swing.JLabel;

/** A label that never gets narrower, so that what stands beside it does not move. */
final class SteadyLabel extends JLabel {
    private static final long serialVersionUID = 1L;

    private static final Pattern NUMBER = Pattern.compile("\\d+");

    private int widest;

    /** Keeps room for a text that may come. */
    void reserve(String text) {
        widest = Math.max(widest, getFontMetrics(getFont()).stringWidth(text));
    }

    /**
     * Says a text whose first number counts upwards.
     *
     * @param last to where it counts
     */
    void show(String text, int last) {
        String longest = "0".repeat(String.valueOf(last).length());
        Matcher number = NUMBER.matcher(text);
        reserve(text);
        if (number.find() && number.group().length() < longest.length())
            reserve(number.replaceFirst(longest));
        setText(text);
    }

    @Override
    public Dimension getPreferredSize() {
        Dimension size = super.getPreferredSize();
        return new Dimension(Math.max(size.width, widest), size.height);
    }

    @Override
    public Dimension getMinimumSize() {
        return getPreferredSize();
    }
}
