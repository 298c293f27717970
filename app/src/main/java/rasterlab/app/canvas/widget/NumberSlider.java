package rasterlab.app.canvas.widget;

import java.awt.Dimension;
import java.util.function.DoubleConsumer;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.RoundTicks;

/** A real number on a slider, with the number behind it in a column of its own. */
public final class NumberSlider extends JPanel {
    private static final long serialVersionUID = 1L;

    private final double least;
    private final double most;
    private final boolean logarithmic;
    private final JSlider slider;
    private final JLabel reading = new Reading();
    private boolean refreshing;

    /**
     * @param said the slider's name for assistive technology
     * @param logarithmic whether equal ways are equal factors; then {@code least} is above 0
     * @param notches equal ways between least and most
     * @param changed told the number that the user chooses
     */
    public NumberSlider(
            String name,
            String said,
            double least,
            double most,
            boolean logarithmic,
            int notches,
            DoubleConsumer changed) {
        super(new MigLayout("insets 0 0 0 4, gap 6", "[grow,fill,0::][pref!,right]", "[center]"));
        this.least = least;
        this.most = most;
        this.logarithmic = logarithmic;
        slider = new JSlider(0, notches);
        slider.setName(name);
        slider.getAccessibleContext().setAccessibleName(said);
        slider.setToolTipText(said);
        reading.setName(name + ".value");
        slider.addChangeListener(
                e -> {
                    if (!refreshing) changed.accept(number(slider.getValue()));
                });
        add(slider, "wmin 40");
        add(reading);
    }

    /** A label's mnemonic leads to the slider itself. */
    @Override
    public void requestFocus() {
        slider.requestFocus();
    }

    /**
     * Shows a number without telling anybody; one outside the range at the nearer end.
     *
     * @param text how it is written
     */
    public void show(double number, String text) {
        refreshing = true;
        slider.setValue(notch(number));
        refreshing = false;
        reading.setText(text);
    }

    /** A number as wide as the longest usual one, so that sliders below each other end together. */
    private static final class Reading extends JLabel {
        private static final long serialVersionUID = 1L;

        private static final String LONGEST = "0.000 ρ";

        Reading() {
            super("", TRAILING);
        }

        @Override
        public Dimension getPreferredSize() {
            Dimension own = super.getPreferredSize();
            int longest = getFontMetrics(getFont()).stringWidth(LONGEST);
            return new Dimension(Math.max(own.width, longest), own.height);
        }
    }

    private double number(int notch) {
        double share = (double) notch / slider.getMaximum();
        if (!logarithmic) return least + (most - least) * share;
        double number = least * Math.pow(most / least, share);
        return RoundTicks.rounded(number, number / 10);
    }

    private int notch(double number) {
        double inside = Math.max(least, Math.min(most, number));
        double share =
                logarithmic
                        ? Math.log(inside / least) / Math.log(most / least)
                        : (inside - least) / (most - least);
        return (int) Math.round(share * slider.getMaximum());
    }
}
