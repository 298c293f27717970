package rasterlab.app.canvas;

import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.text.FieldPosition;
import java.text.ParsePosition;
import java.util.Locale;
import javax.swing.JSpinner;
import javax.swing.text.NumberFormatter;

/**
 * The text field of a spinner: shows a minus as wide as plus and also takes a hyphen for it. A
 * number that has more digits than are shown keeps them until what is shown is changed.
 */
public final class NumberEntry extends JSpinner.NumberEditor {
    private static final long serialVersionUID = 1L;

    /**
     * @param pattern of a {@link DecimalFormat}
     */
    public NumberEntry(JSpinner spinner, String pattern, Locale locale) {
        super(spinner, pattern);
        var symbols = DecimalFormatSymbols.getInstance(locale);
        symbols.setMinusSign('−');
        ((NumberFormatter) getTextField().getFormatter()).setFormat(new Format(pattern, symbols));
        getTextField().setValue(spinner.getValue());
    }

    private static final class Format extends DecimalFormat {
        private static final long serialVersionUID = 1L;

        /** For what the pattern would round to 0. */
        private final DecimalFormat tiny;

        private String shown = "";
        private double number;

        Format(String pattern, DecimalFormatSymbols symbols) {
            super(pattern, symbols);
            tiny = new DecimalFormat("0.##E0", symbols);
        }

        @Override
        public StringBuffer format(double next, StringBuffer out, FieldPosition at) {
            int begin = out.length();
            boolean rounded = Math.abs(next) <= 0.5 * Math.pow(10, -getMaximumFractionDigits());
            if (next == 0) super.format(0.0, out, at);
            else if (rounded) tiny.format(next, out, at);
            else super.format(next, out, at);
            shown = out.substring(begin);
            number = next;
            return out;
        }

        @Override
        public Number parse(String text, ParsePosition at) {
            String typed = text.replace('-', '−').replace('e', 'E');
            if (!typed.equals(shown)) return super.parse(typed, at);
            at.setIndex(text.length());
            return number;
        }
    }
}
