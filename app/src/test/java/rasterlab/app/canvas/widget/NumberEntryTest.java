package rasterlab.app.canvas.widget;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.awt.datatransfer.Clipboard;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.Transferable;
import java.io.File;
import java.nio.file.Path;
import java.text.ParseException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.swing.JFormattedTextField;
import javax.swing.JPanel;
import javax.swing.JSpinner;
import javax.swing.JTextField;
import javax.swing.SpinnerNumberModel;
import javax.swing.TransferHandler;
import javax.swing.TransferHandler.TransferSupport;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.canvas.file.DroppedFiles;
import rasterlab.app.canvas.file.FileDrop;
import rasterlab.app.language.Language;
import rasterlab.app.shell.settings.LabTheme;

class NumberEntryTest {
    @BeforeEach
    void usualTheme() throws Exception {
        EventQueue.invokeAndWait(LabTheme.LIGHT::install);
    }

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

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "a number above the range is not marked, 11, en, 'Allowed: from −10 to 10'",
        "a number below the range is not marked, -10.5, ru, 'Допустимо от −10 до 10'",
        "a word is not marked, abc, en, 'Allowed: from −10 to 10'",
        "the start of a text is taken for all of it, 5x7, en, 'Allowed: from −10 to 10'",
        "a number of two readings is guessed, '1,234', en, '1,234 may be 1.234 or 1234: write the one that is meant'",
        "a number in the range is marked, 9.5, en, number",
    })
    void refusedNumberIsFramedBesideTheReason(
            String mistake, String typed, String language, String told) {
        Locale locale = Locale.forLanguageTag(language);
        var field = new NumberField("n", "number", -10, 10, 1, locale, value -> {});
        var text = ((JSpinner.DefaultEditor) field.getEditor()).getTextField();
        text.setText(typed);
        boolean refused = !told.equals("number");
        assertEquals(
                refused ? "error" : null, field.getClientProperty("JComponent.outline"), mistake);
        if (refused) assertEquals(told, text.getToolTipText(), mistake);
        text.setText("1");
        assertNull(field.getClientProperty("JComponent.outline"), mistake);
        assertEquals("number", text.getToolTipText(), mistake);
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "an English comma ends the number, '2,75', en, 2.75",
        "a Russian point ends the number, -30.5, ru, -30.5",
        "the end of a text is dropped, 5x7, en,",
        "a second decimal sign is dropped, 1.5.2, ru,",
        "a group sign is taken for a decimal sign, '1,234', en,",
    })
    void whatIsTypedIsTakenWholeOrNotAtAll(
            String mistake, String typed, String language, Double number) {
        List<Double> told = new ArrayList<>();
        Locale locale = Locale.forLanguageTag(language);
        var field = new NumberField("n", "number", -1e4, 1e4, 1, locale, told::add);
        field.show(7);
        enter(typed, field);
        assertEquals(number == null ? List.of() : List.of(number), told, mistake);
        assertEquals(number == null ? 7 : number, field.getValue(), mistake);
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "a fraction is rounded without a word, 3.7, en, 7, 'Allowed: whole numbers from −10 to 10'",
        "a fraction is cut without a word, '3,7', ru, 7, 'Допустимы целые числа от −10 до 10'",
        "zeros behind the point are a fraction, 3.0, en, 3,",
        "a whole number is refused, -4, ru, -4,",
    })
    void wholeNumbersTakeNoFraction(
            String mistake, String typed, String language, double number, String reason) {
        Locale locale = Locale.forLanguageTag(language);
        var field = new NumberField("n", "number", -10, 10, 1, locale, value -> {});
        field.takeOnlyWhole();
        field.show(7);
        enter("abc", field);
        enter(typed, field);
        assertEquals(number, field.getValue(), mistake);
        String told = reason == null ? "number" : reason;
        assertEquals(told, text(field).getToolTipText(), mistake);
    }

    /** Types a text in place of what is there, and Enter. */
    private static void enter(String typed, NumberField field) {
        text(field).setText(typed);
        try {
            field.commitEdit();
        } catch (ParseException e) {
            assertEquals("error", field.getClientProperty("JComponent.outline"), typed);
        }
    }

    private static JFormattedTextField text(JSpinner field) {
        return ((JSpinner.DefaultEditor) field.getEditor()).getTextField();
    }

    @Test
    @DisplayName("the reason stays that of the text before")
    void reasonIsThatOfTheTextThatIsThere() {
        var field = new NumberField("n", "number", -10, 10, 1, Locale.ENGLISH, value -> {});
        enter("abc", field);
        enter("2,000", field);
        assertEquals(
                "2,000 may be 2 or 2000: write the one that is meant",
                text(field).getToolTipText());
        enter("2,0001x", field);
        assertEquals("Allowed: from −10 to 10", text(field).getToolTipText());
    }

    @Test
    @DisplayName("a range is told with hundreds of digits")
    void longRangeIsToldWithPowersOfTen() {
        double most = Double.MAX_VALUE;
        var field = new NumberField("n", "number", -most, most, 1, Locale.ENGLISH, value -> {});
        enter("1e999", field);
        assertEquals("Allowed: from −1.8·10³⁰⁸ to 1.8·10³⁰⁸", text(field).getToolTipText());
    }

    @ParameterizedTest(name = "a number is cut where no type is small enough, or changes: {0} wide")
    @CsvSource({"60, −1199999999", "34, −1.2E9", "600, −1199999999"})
    void numberWithoutRoomIsRounded(int width, String shown) throws ParseException {
        var spinner =
                new JSpinner(
                        new SpinnerNumberModel(
                                (Number) (-1_199_999_999),
                                Integer.MIN_VALUE,
                                Integer.MAX_VALUE,
                                1));
        var entry = new NumberEntry(spinner, "0", Locale.ENGLISH);
        spinner.setEditor(entry);
        entry.setSize(width, 24);
        entry.doLayout();
        var field = entry.getTextField();
        assertEquals(shown, field.getText());
        int wide = field.getFontMetrics(field.getFont()).stringWidth(shown);
        assertTrue(wide <= field.getWidth() - 6, wide + " in " + field.getWidth());
        spinner.commitEdit();
        assertEquals(-1_199_999_999, ((Number) spinner.getValue()).intValue());
        spinner.setValue(7);
        assertEquals("7", field.getText());
        entry.setSize(600, 24);
        spinner.setValue(-1_199_999_998);
        entry.doLayout();
        assertEquals("−1199999998", field.getText());
    }

    @Test
    @DisplayName("a file dropped on a number is refused without a word")
    void fileGoesToWhatIsAround() throws Exception {
        var file = new File("a.scene.json");
        List<Path> taken = new ArrayList<>();
        EventQueue.invokeAndWait(
                () -> {
                    var around = new JPanel();
                    around.setTransferHandler(new FileDrop(around, Language.ENGLISH, taken::add));
                    var field = field(around);
                    assertTrue(put(DroppedFiles.of(file), field));
                    assertEquals("0", field.getText());
                });
        EventQueue.invokeAndWait(() -> {});
        assertEquals(List.of(file.toPath()), taken);
    }

    @Test
    @DisplayName(
            "where nothing takes files a number does, or text is not pasted or copied any more")
    void textIsTakenAndGiven() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    JTextField field = field(new JPanel());
                    assertFalse(put(DroppedFiles.of(new File("a.txt")), field));
                    field.selectAll();
                    assertTrue(put(new StringSelection("8"), field));
                    assertEquals("8", field.getText());
                    field.selectAll();
                    var clipboard = new Clipboard("own");
                    field.getTransferHandler()
                            .exportToClipboard(field, clipboard, TransferHandler.COPY);
                    assertTrue(clipboard.isDataFlavorAvailable(DataFlavor.stringFlavor));
                });
    }

    private static JTextField field(JPanel around) {
        var number = new NumberField("n", "number", 0, 10, 1, Locale.ENGLISH, value -> {});
        around.add(number);
        return ((JSpinner.DefaultEditor) number.getEditor()).getTextField();
    }

    private static boolean put(Transferable content, JTextField field) {
        var support = new TransferSupport(field, content);
        return field.getTransferHandler().canImport(support)
                && field.getTransferHandler().importData(support);
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
