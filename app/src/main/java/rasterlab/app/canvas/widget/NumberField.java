package rasterlab.app.canvas.widget;

import java.util.Locale;
import java.util.function.DoubleConsumer;
import javax.swing.JSpinner;
import javax.swing.SpinnerNumberModel;

/** A number that can be typed, or changed by a step with the arrow keys. */
public final class NumberField extends JSpinner {
    private static final long serialVersionUID = 1L;

    private final transient DoubleConsumer changed;
    private boolean refreshing;

    /**
     * @param name the component's name
     * @param said its name for assistive technology
     * @param changed told a number that the user enters
     */
    public NumberField(
            String name,
            String said,
            double low,
            double high,
            double step,
            Locale locale,
            DoubleConsumer changed) {
        super(new SpinnerNumberModel(low, low, high, step));
        this.changed = changed;
        setLocale(locale);
        var editor = new NumberEntry(this, "0.#####", locale);
        editor.getTextField().setColumns(4);
        editor.getTextField().setName(name + ".text");
        editor.getTextField().getAccessibleContext().setAccessibleName(said);
        setEditor(editor);
        setName(name);
        getAccessibleContext().setAccessibleName(said);
        setToolTipText(said);
        addChangeListener(e -> tell());
    }

    /** Takes no fraction from now on. */
    public void takeOnlyWhole() {
        ((NumberEntry) getEditor()).takeOnlyWhole();
    }

    private void tell() {
        if (!refreshing) changed.accept(((Number) getValue()).doubleValue());
    }

    /** Shows a number without telling anybody. */
    public void show(double value) {
        refreshing = true;
        setValue(value);
        refreshing = false;
    }
}
