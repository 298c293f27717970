package rasterlab.app.plan.least;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.lab.Inspector;
import rasterlab.app.canvas.widget.KeyedControls;
import rasterlab.app.canvas.widget.NumberSlider;
import rasterlab.app.canvas.widget.WrappedText;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.plan.bill.Bills;

/** The tolerance in an inspector, and the bill of the picture that is enough for it. */
public final class LeastRows {
    private static final int PIXEL_NOTCHES = 34;
    private static final int LEVEL_NOTCHES = 32;

    private final Inspector column;
    private final Texts texts;
    private final PlanReadings readings;
    private final JCheckBox on;
    private final NumberSlider pixels;
    private final NumberSlider levels;
    private final JLabel predictedError;
    private final JLabel measuredError;
    private final JLabel predictedTime;
    private final JLabel measuredTime;
    private final JLabel kept;
    private final WrappedText decisions = new WrappedText("least.decisions");
    private final JCheckBox magnified;
    private final List<JComponent> rows = new ArrayList<>();
    private PlanWish shown = PlanWish.FIRST;

    /**
     * @param column whose texts name the heading
     * @param changed told what the user chooses
     */
    public LeastRows(Inspector column, Language language, Consumer<PlanWish> changed) {
        this.column = column;
        texts = Texts.of("plan", language);
        readings = new PlanReadings(language);
        column.heading("heading.least");
        on = KeyedControls.box("least", texts, drawn -> changed.accept(shown.with(drawn)));
        column.wide(on);
        pixels =
                slider(
                        "least.pixels",
                        new NumberSlider(
                                "least.pixels",
                                texts.text("least.pixels.hint"),
                                PlanWish.LEAST_PIXELS,
                                PlanWish.MOST_PIXELS,
                                true,
                                PIXEL_NOTCHES,
                                chosen -> changed.accept(shown.withPixels(chosen))));
        levels =
                slider(
                        "least.levels",
                        new NumberSlider(
                                "least.levels",
                                texts.text("least.levels.hint"),
                                0,
                                PlanWish.MOST_LEVELS,
                                false,
                                LEVEL_NOTCHES,
                                chosen -> changed.accept(shown.withLevels(chosen))));
        predictedError = value("least.error");
        measuredError = value("least.measured");
        predictedTime = value("least.time");
        measuredTime = value("least.timed");
        kept = value("least.kept");
        column.wide(decisions);
        magnified =
                KeyedControls.box(
                        "least.magnified",
                        texts,
                        drawn -> changed.accept(shown.withMagnified(drawn)));
        column.wide(magnified);
    }

    private NumberSlider slider(String key, NumberSlider slider) {
        column.row(key + ".label", texts.text(key), slider);
        return slider;
    }

    private JLabel value(String key) {
        var value = new JLabel(" ");
        value.setName(key + ".value");
        value.setToolTipText(texts.text(key + ".hint"));
        column.row(key, texts.text(key), value);
        rows.add(value);
        return value;
    }

    /**
     * @param possible whether the present choice is one that plans are made for
     * @param picture that is shown; empty where none was drawn by a plan
     * @param bills of such pictures; pale while they are of an earlier one
     */
    public void show(
            PlanWish wish,
            boolean possible,
            Optional<PlannedPicture> picture,
            Bills<PlannedPicture, PlanBill> bills) {
        shown = wish;
        on.setSelected(wish.on());
        pixels.show(wish.pixels(), Shown.number(wish.pixels(), texts.locale()));
        levels.show(wish.levels(), Shown.number(wish.levels(), texts.locale()));
        magnified.setSelected(wish.magnified());
        Optional<PlannedPicture> planned = picture.filter(drawn -> possible);
        Optional<PlanBill> bill = bills.bill();
        for (JComponent row : rows) column.showRow(row, planned.isPresent());
        boolean refused = wish.on() && !possible;
        decisions.setVisible(planned.isPresent() || refused);
        magnified.setVisible(wish.on());
        write(predictedError, planned, drawn -> readings.predictedError(drawn.plan()));
        write(predictedTime, planned, drawn -> readings.predictedTime(drawn.plan()));
        write(kept, planned, readings::kept);
        write(measuredError, bill, found -> readings.measuredError(found.trial()));
        write(measuredTime, bill, found -> readings.measuredTime(found.trial()));
        measuredError.setEnabled(bills.current());
        measuredTime.setEnabled(bills.current());
        decisions.show(
                planned.map(drawn -> readings.decisions(drawn.plan()))
                        .orElse(refused ? texts.text("least.none") : ""));
    }

    private static <T> void write(JLabel row, Optional<T> told, Function<T, String> said) {
        row.setText(told.map(said).orElse("–"));
    }
}
