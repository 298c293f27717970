package rasterlab.app.practice;

import java.util.Optional;
import java.util.function.LongConsumer;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.language.Texts;
import rasterlab.exercises.predicting.Sheet;

/** The seed of the questions, where another can be typed to have its data. */
final class SeedField extends JPanel {
    private static final long serialVersionUID = 1L;

    private static final int COLUMNS = 7;

    private final JTextField field = new JTextField(COLUMNS);

    /**
     * @param typed told a seed that was typed
     * @param refused told what is allowed where something else was typed
     */
    SeedField(Texts texts, LongConsumer typed, Runnable refused) {
        super(new MigLayout("insets 0, gap 6", "[][]", ""));
        field.setName("practice.seed");
        field.setToolTipText(texts.text("seed.hint"));
        var label = new JLabel(texts.text("seed"));
        label.setLabelFor(field);
        field.addActionListener(e -> read(field.getText()).ifPresentOrElse(typed::accept, refused));
        add(label);
        add(field);
    }

    private static Optional<Long> read(String text) {
        String digits = text.strip();
        if (!digits.matches("\\d{1,16}")) return Optional.empty();
        return Optional.of(Long.parseLong(digits)).filter(seed -> seed <= Sheet.MOST_SEED);
    }

    void show(long seed) {
        String text = String.valueOf(seed);
        if (!text.equals(field.getText())) field.setText(text);
    }
}
