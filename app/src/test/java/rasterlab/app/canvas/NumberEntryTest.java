package rasterlab.app.canvas;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.text.ParseException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.swing.JSpinner;
import javax.swing.SpinnerNumberModel;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class NumberEntryTest {
    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "a hyphen is not taken for a minus, -2.5, en, -2.5, −2.5",
        "a minus is refused, −2.5, en, -2.5, −2.5",
        "the Russian comma is lost, '-2,5', ru, -2.5, '−2,5'",
        "a number without a minus changes, 7, en, 7, 7",
    })
    void takesBothSignsAndShowsAMinus(
            String mistake, String typed, String language, double number, String shown)
            throws ParseException {
        var spinner = new JSpinner(new SpinnerNumberModel(0.0, -10, 10, 1));
        var entry = new NumberEntry(spinner, "0.####", Locale.forLanguageTag(language));
        spinner.setEditor(entry);
        entry.getTextField().setText(typed);
        spinner.commitEdit();
        assertEquals(number, spinner.getValue(), mistake);
        assertEquals(shown, entry.getTextField().getText(), mistake);
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "a tiny number is shown as 0, -4e-170, en, −4E−170",
        "a tiny number has no comma, 1.5e-7, ru, '1,5E−7'",
        "a minus stands before 0, -0.0, en, 0",
        "digits that are not shown are lost, 0.123456789, en, 0.12346",
    })
    void numberThatIsNotChangedStaysAsItIs(
            String mistake, double number, String language, String shown) throws ParseException {
        List<Double> told = new ArrayList<>();
        Locale locale = Locale.forLanguageTag(language);
        var field = new NumberField("n", "number", -10, 10, 1, locale, told::add);
        field.show(number);
        var text = ((JSpinner.DefaultEditor) field.getEditor()).getTextField();
        assertEquals(shown, text.getText(), mistake);
        text.setText(text.getText());
        field.commitEdit();
        assertEquals(number, field.getValue(), mistake);
        assertEquals(List.of(), told, mistake);
    }

    @Test
    @DisplayName("a tiny number cannot be typed")
    void takesPowersOfTen() throws ParseException {
        List<Double> told = new ArrayList<>();
        var field = new NumberField("n", "number", -10, 10, 1, Locale.ENGLISH, told::add);
        field.show(-4e-170);
        var text = ((JSpinner.DefaultEditor) field.getEditor()).getTextField();
        text.setText("-4.5e-170");
        field.commitEdit();
        assertEquals(List.of(-4.5e-170), told);
    }

    @Test
    @DisplayName("a field of the labs tells no number, or shows a hyphen")
    void fieldTellsWhatIsTyped() throws ParseException {
        List<Double> told = new ArrayList<>();
        var field = new NumberField("n", "number", -10, 10, 1, Locale.ENGLISH, told::add);
        field.show(-3);
        var text = ((JSpinner.DefaultEditor) field.getEditor()).getTextField();
        assertEquals("−3", text.getText());
        text.setText("-4");
        field.commitEdit();
        assertEquals(List.of(-4.0), told);
    }
}
