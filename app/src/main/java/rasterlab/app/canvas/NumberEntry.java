package rasterlab.app.canvas;

import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.text.ParsePosition;
import java.util.Locale;
import javax.swing.JSpinner;
import javax.swing.text.NumberFormatter;

/** The text field of a spinner: shows a minus as wide as plus and also takes a hyphen for it. */
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

        Format(String pattern, DecimalFormatSymbols symbols) {
            super(pattern, symbols);
        }

        @Override
        public Number parse(String text, ParsePosition at) {
            return super.parse(text.replace('-', '−'), at);
        }
    }
}
