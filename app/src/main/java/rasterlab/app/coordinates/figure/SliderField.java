package rasterlab.app.coordinates.figure;

import com.formdev.flatlaf.util.UIScale;
import java.util.Locale;
import java.util.function.DoubleConsumer;
import javax.swing.JPanel;
import javax.swing.JSlider;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.widget.NumberField;

/** A number on a slider, with a field behind it in which it can be typed. */
public final class SliderField extends JPanel {
    private static final long serialVersionUID = 1L;

    private static final int NOTCHES = 360;

    private final transient Range range;
    private final JSlider slider = new JSlider(0, NOTCHES);
    private final NumberField field;
    private boolean refreshing;

    /**
     * Which numbers there are.
     *
     * @param low the least that can be typed
     * @param high the largest that can be typed
     * @param from the least on the slider
     * @param to the largest on the slider
     * @param step of the field's arrow keys
     * @param logarithmic whether equal ways on the slider are equal factors
     */
    public record Range(
            double low, double high, double from, double to, double step, boolean logarithmic) {
        double number(int notch) {
            double share = (double) notch / NOTCHES;
            double number =
                    logarithmic
                            ? from * Math.pow(to / from, share)
                            : Math.rint((from + (to - from) * share) / step) * step;
            double round = Math.rint(number * 1e6) / 1e6;
            return Math.max(low, Math.min(high, logarithmic ? Math.rint(round * 10) / 10 : round));
        }

        int notch(double number) {
            double inside = Math.max(from, Math.min(to, number));
            double share =
                    logarithmic
                            ? Math.log(inside / from) / Math.log(to / from)
                            : (inside - from) / (to - from);
            return (int) Math.round(share * NOTCHES);
        }
    }

    /** Width of the field in type of usual size. */
    private static final int FIELD = 112;

    /**
     * @param name of the slider; the field is called {@code NAME.field}
     * @param said its name for assistive technology
     * @param changed told the number that the user chooses
     */
    public SliderField(
            String name, String said, Range range, Locale locale, DoubleConsumer changed) {
        super(
                new MigLayout(
                        "insets 0, gap 6",
                        "[grow,fill,0::][" + UIScale.scale(FIELD) + "!,fill]",
                        "[center]"));
        this.range = range;
        slider.setName(name);
        slider.setToolTipText(said);
        slider.getAccessibleContext().setAccessibleName(said);
        slider.addChangeListener(
                e -> {
                    if (!refreshing) changed.accept(range.number(slider.getValue()));
                });
        field =
                new NumberField(
                        name + ".field",
                        said,
                        range.low(),
                        range.high(),
                        range.step(),
                        locale,
                        changed);
        add(slider, "wmin 30");
        add(field, "wmin 0");
    }

    /** Takes no fraction in the field from now on. */
    public void takeOnlyWhole() {
        field.takeOnlyWhole();
    }

    /** A label's mnemonic leads to the slider. */
    @Override
    public void requestFocus() {
        slider.requestFocus();
    }

    @Override
    public void setEnabled(boolean enabled) {
        super.setEnabled(enabled);
        slider.setEnabled(enabled);
        field.setEnabled(enabled);
    }

    /** Shows a number without telling anybody. */
    public void show(double number) {
        refreshing = true;
        slider.setValue(range.notch(number));
        refreshing = false;
        field.show(number);
    }
}
