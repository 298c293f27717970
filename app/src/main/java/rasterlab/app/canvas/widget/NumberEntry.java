package rasterlab.app.canvas.widget;

import com.formdev.flatlaf.FlatClientProperties;
import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Insets;
import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.text.FieldPosition;
import java.text.ParsePosition;
import java.util.List;
import java.util.Locale;
import javax.swing.JFormattedTextField;
import javax.swing.JSpinner;
import javax.swing.JTextField;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import javax.swing.text.NumberFormatter;
import rasterlab.app.canvas.Shown;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

/**
 * The text field of a spinner: shows a minus as wide as plus and no groups of digits, and takes
 * what {@link TypedNumber} reads as one number. Anything else is refused: a text with something
 * left over, one that reads as two numbers, a number outside the range, and a fraction where the
 * pattern shows none. A number that has more digits than are shown keeps them until what is shown
 * is changed.
 */
public final class NumberEntry extends JSpinner.NumberEditor {
    private static final long serialVersionUID = 1L;

    private static final int SMALLEST_TYPE = 6;

    /** The digits after the decimal sign of a number in a sentence. */
    private static final int DIGITS = 5;

    /** Room for the caret and for the rounding of scaled padding. */
    private static final int SPARE = 3;

    private final transient Format format;
    private final transient Texts texts;
    private final transient RefusalTip tip = new RefusalTip(getTextField());
    private Font usual;

    /** The smaller type that a long number has; null as long as the usual one fits. */
    private Font fitted;

    private Dimension room;

    /**
     * @param pattern of a {@link DecimalFormat}
     */
    public NumberEntry(JSpinner spinner, String pattern, Locale locale) {
        super(spinner, pattern);
        var symbols = DecimalFormatSymbols.getInstance(locale);
        symbols.setMinusSign('−');
        format = new Format(pattern, symbols);
        texts = Texts.of("canvas", Language.of(locale));
        ((NumberFormatter) getTextField().getFormatter()).setFormat(format);
        getTextField().setValue(spinner.getValue());
        FieldDrop.on(getTextField());
        getTextField().addPropertyChangeListener("editValid", e -> tellValidity(spinner));
        getTextField().getDocument().addDocumentListener(new WhileRefused(spinner));
        getTextField().addPropertyChangeListener("value", e -> fit());
    }

    /** Takes no fraction from now on. */
    void takeOnlyWhole() {
        format.setMaximumFractionDigits(0);
    }

    /**
     * A number that is refused is framed, and the reason is told beside it, also where no mouse is.
     */
    private void tellValidity(JSpinner spinner) {
        boolean valid = getTextField().isEditValid();
        spinner.putClientProperty(
                FlatClientProperties.OUTLINE, valid ? null : FlatClientProperties.OUTLINE_ERROR);
        String reason = valid ? "" : refusal();
        getTextField().setToolTipText(valid ? spinner.getToolTipText() : reason);
        tip.tell(reason);
    }

    /** The fault may change while a text goes on being refused. */
    private final class WhileRefused implements DocumentListener {
        private final JSpinner spinner;

        WhileRefused(JSpinner spinner) {
            this.spinner = spinner;
        }

        @Override
        public void insertUpdate(DocumentEvent e) {
            if (!getTextField().isEditValid()) tellValidity(spinner);
        }

        @Override
        public void removeUpdate(DocumentEvent e) {
            insertUpdate(e);
        }

        @Override
        public void changedUpdate(DocumentEvent e) {}
    }

    private String refusal() {
        String text = getTextField().getText();
        List<Double> readings = format.typed.readings(text);
        if (readings.size() > 1)
            return texts.text(
                    "number.twofold",
                    text.strip(),
                    numberText(readings.get(0)),
                    numberText(readings.get(1)));
        return texts.text(
                format.onlyWhole() ? "number.allowed.whole" : "number.allowed",
                numberText((Number) getModel().getMinimum()),
                numberText((Number) getModel().getMaximum()));
    }

    private String numberText(Number number) {
        return Shown.number(number.doubleValue(), DIGITS, texts.locale());
    }

    @Override
    public void doLayout() {
        super.doLayout();
        fit();
    }

    /** The size with the default type: a smaller one would make the field smaller in turn. */
    @Override
    public Dimension getPreferredSize() {
        JTextField field = getTextField();
        if (room == null || !field.getFont().equals(fitted)) room = super.getPreferredSize();
        return new Dimension(room);
    }

    /**
     * Makes the type so small that the whole number is seen: a part reads as another number. One
     * that would be too small to be read is rounded to a few digits and a power of ten instead.
     */
    private void fit() {
        JFormattedTextField field = getTextField();
        if (field.getWidth() == 0) return;
        getPreferredSize();
        if (!field.getFont().equals(fitted)) usual = field.getFont();
        int free = field.getWidth() - sideRoom(field) - SPARE;
        boolean typed = !field.getText().equals(format.shown);
        String whole = typed ? field.getText() : format.whole;
        boolean rounded = !typed && !fits(whole, smallest(), free);
        if (!typed && rounded != format.rounded) {
            format.rounded = rounded;
            field.setValue(field.getValue());
        }
        Font next = usual;
        while (next.getSize() > SMALLEST_TYPE && !fits(field.getText(), next, free))
            next = next.deriveFont(next.getSize() - 1f);
        if (next.equals(field.getFont())) return;
        fitted = next.equals(usual) ? null : next;
        field.setFont(next);
    }

    private Font smallest() {
        return usual.deriveFont((float) Math.min(SMALLEST_TYPE, usual.getSize()));
    }

    private boolean fits(String text, Font type, int free) {
        return getTextField().getFontMetrics(type).stringWidth(text) <= free;
    }

    /**
     * The room that a field keeps free on both sides of its text: FlatLaf's padding is no inset.
     */
    private static int sideRoom(JTextField field) {
        Insets insets = field.getInsets();
        int beside = insets.left + insets.right;
        if (field.getClientProperty(FlatClientProperties.TEXT_FIELD_PADDING) instanceof Insets in)
            beside += UIScale.scale(in.left) + UIScale.scale(in.right);
        return beside;
    }

    private static final class Format extends DecimalFormat {
        private static final long serialVersionUID = 1L;

        /** The format for what the pattern would round to 0, and for what has too many digits. */
        private final DecimalFormat power;

        /** Whether there is no room for all digits. */
        private boolean rounded;

        private String shown = "";

        /** The text that would be shown if there were room. */
        private String whole = "";

        private double number;

        private final TypedNumber typed;

        Format(String pattern, DecimalFormatSymbols symbols) {
            super(pattern, symbols);
            power = new DecimalFormat("0.##E0", symbols);
            typed = new TypedNumber(symbols.getGroupingSeparator());
        }

        boolean onlyWhole() {
            return getMaximumFractionDigits() == 0;
        }

        @Override
        public StringBuffer format(long next, StringBuffer out, FieldPosition at) {
            return format((double) next, out, at);
        }

        @Override
        public StringBuffer format(double next, StringBuffer out, FieldPosition at) {
            boolean tiny = Math.abs(next) <= 0.5 * Math.pow(10, -getMaximumFractionDigits());
            var digits = new StringBuffer();
            if (next == 0) super.format(0.0, digits, at);
            else if (tiny) power.format(next, digits, at);
            else super.format(next, digits, at);
            whole = digits.toString();
            shown = rounded ? power.format(next) : whole;
            number = next;
            return out.append(shown);
        }

        @Override
        public Number parse(String text, ParsePosition at) {
            boolean same = text.replace('-', '−').replace('e', 'E').equals(shown);
            List<Double> readings = same ? List.of(number) : typed.readings(text);
            if (readings.size() != 1 || !same && onlyWhole() && readings.get(0) % 1 != 0) {
                at.setErrorIndex(0);
                return null;
            }
            at.setIndex(text.length());
            return readings.get(0);
        }
    }
}
