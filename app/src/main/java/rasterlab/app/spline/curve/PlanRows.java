package rasterlab.app.spline.curve;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.lab.Inspector;
import rasterlab.app.canvas.widget.KeyedControls;
import rasterlab.app.canvas.widget.NumberSlider;
import rasterlab.app.language.Texts;
import rasterlab.engine.spline.plan.CurvePlan;
import rasterlab.engine.spline.plan.CurvePrices;

/** The plan of a curve in the inspector: how often it is drawn, and what each way costs then. */
public final class PlanRows {
    /** Notches of the slider: 25 for each power of ten. */
    private static final int NOTCHES = 100;

    private final Inspector column;
    private final Texts texts;
    private final NumberSlider times;
    private final JCheckBox planned;
    private final JLabel picked;
    private final Map<String, JLabel> ways = new LinkedHashMap<>();
    private CurvePlanning shown = CurvePlanning.FIRST;

    /**
     * @param texts of the lab
     * @param changed told what the user chooses
     */
    public PlanRows(Inspector column, Texts texts, Consumer<CurvePlanning> changed) {
        this.column = column;
        this.texts = texts;
        column.heading("heading.plan");
        times =
                new NumberSlider(
                        "times",
                        texts.text("times.hint"),
                        1,
                        CurvePlanning.MOST_TIMES,
                        true,
                        NOTCHES,
                        chosen -> changed.accept(shown.with((int) Math.round(chosen))));
        column.row("times", times);
        planned = KeyedControls.box("planned", texts, on -> changed.accept(shown.with(on)));
        column.wide(planned);
        picked = column.value("picked");
        picked.setToolTipText(texts.text("picked.hint"));
        for (String method : CurvePrices.METHODS) {
            var way = new JLabel(" ");
            way.setName("way." + method + ".value");
            way.setToolTipText(texts.text("way.hint", CurvePrices.measured().origin()));
            column.row("way." + method, method, way);
            ways.put(method, way);
        }
    }

    /**
     * @param plan of the drawing; empty where there is none
     */
    public void show(CurvePlanning planning, Optional<CurvePlan> plan) {
        shown = planning;
        times.show(planning.times(), Shown.number(planning.times(), texts.locale()));
        planned.setSelected(planning.on());
        picked.setText(plan.map(this::picked).orElseGet(() -> texts.text("picked.none")));
        ways.forEach(
                (method, row) -> {
                    Optional<CurvePlan.MethodPolylines> way =
                            plan.flatMap(found -> way(found, method));
                    column.showRow(row, plan.isPresent());
                    row.setText(way.map(one -> costText(one, plan.get().times())).orElse("–"));
                });
    }

    private static Optional<CurvePlan.MethodPolylines> way(CurvePlan plan, String method) {
        List<CurvePlan.MethodPolylines> ways = plan.ways();
        return ways.stream().filter(way -> way.method().equals(method)).findFirst();
    }

    private String picked(CurvePlan plan) {
        CurvePlan.MethodPolylines best = plan.chosen();
        double saved = 1 - best.nanos(plan.times()) / plan.dearest().nanos(plan.times());
        return texts.text("picked.saves", best.method(), Long.toString(Math.round(100 * saved)));
    }

    private String costText(CurvePlan.MethodPolylines way, long drawn) {
        return texts.text(
                "way",
                way.segments(),
                Shown.number(way.errorPixels(), 3, texts.locale()),
                Shown.number(way.nanos(drawn) / 1000, 1, texts.locale()));
    }
}
