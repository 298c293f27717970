package rasterlab.app.plan;

import java.io.PrintStream;
import java.util.Map;
import rasterlab.app.language.Texts;
import rasterlab.engine.plan.Combination;
import rasterlab.engine.plan.Plan;
import rasterlab.engine.plan.PlanDecision;
import rasterlab.engine.plan.PlanTrial;

/** The bill of a plan for people, in one language. */
record PlanText(PlanReport report, Texts texts) {
    private static final String TERMS = "terms";

    void print(PrintStream out) {
        PlanTrial trial = report.trial();
        Plan plan = trial.plan();
        out.println(
                texts.text(
                        "head",
                        plan.full().scene().name(),
                        plan.full().width() + "×" + plan.full().height(),
                        number(plan.tolerance().pixels()),
                        number(plan.tolerance().levels())));
        plan.decisions().forEach(decision -> print(out, decision));
        out.println(
                texts.text(
                        "predicted",
                        number(plan.predictedPixels()),
                        number(plan.predictedLevels()),
                        number(plan.cost().milliseconds()),
                        number(plan.fullCost().milliseconds())));
        out.println(
                texts.text(
                        "measured",
                        number(trial.error().levels()),
                        Long.toString(trial.error().wrong()),
                        number(100 * trial.error().share()),
                        processor(trial)));
        out.println(
                texts.text("wall", number(trial.milliseconds()), number(trial.fullMilliseconds())));
        printCounts(out, plan);
        out.println(range(plan));
        var path = report.path();
        out.println(
                texts.text(
                        "deciding",
                        number(path.firstMilliseconds()),
                        number(path.perPicture()),
                        Integer.toString(path.pictures()),
                        Integer.toString(path.plans()),
                        number(100 * path.perPicture() / trial.fullProcessor())));
        if (trial.steppedBack() > 0) out.println(texts.text("back", trial.steppedBack() + ""));
        out.println(texts.text("costs", CostOrigin.translated(texts, report.costs())));
        if (!report.proof().isEmpty()) out.println(proof());
    }

    private void print(PrintStream out, PlanDecision decision) {
        boolean terms = decision.saves() && decision.subject().equals(TERMS);
        out.println(
                texts.text(
                        terms ? "decision.terms" : decision.saves() ? "decision" : "kept",
                        texts.text("subject." + decision.subject()),
                        PlanReport.word(texts, decision.chosen()),
                        PlanReport.word(texts, decision.instead())));
        out.println("    " + PlanReport.reason(texts, decision));
    }

    /**
     * Both processor times; a plan that leaves nothing out has the full picture's, measured twice.
     */
    private String processor(PlanTrial trial) {
        String plan = number(trial.processor());
        String full = number(trial.fullProcessor());
        return trial.plan().saves()
                ? texts.text(
                        "processor", plan, full, number(trial.processor() / trial.fullProcessor()))
                : texts.text("processor.same", plan, full);
    }

    private void printCounts(PrintStream out, Plan plan) {
        out.println(texts.text("counted"));
        var full = plan.fullCost().work().stages();
        for (Map.Entry<String, Long> stage : plan.cost().work().stages().entrySet())
            if (stage.getValue() > 0 || full.get(stage.getKey()) > 0)
                out.println(
                        texts.text(
                                "stage",
                                texts.text("stage." + stage.getKey()),
                                stage.getValue().toString(),
                                full.get(stage.getKey()).toString()));
    }

    /** The cheapest of all combinations beside the plan's own, which is timed among them. */
    private String proof() {
        Combination best = report.proof().get(0);
        String all = Integer.toString(report.proof().size());
        if (isThePlan(best)) return texts.text("proof.same", all, best.name());
        double own =
                report.proof().stream()
                        .filter(this::isThePlan)
                        .findFirst()
                        .map(Combination::processor)
                        .orElse(report.trial().processor());
        return texts.text(
                "proof",
                all,
                best.name(),
                number(best.processor()),
                number(own / best.processor()));
    }

    private boolean isThePlan(Combination way) {
        var least = report.trial().plan().least();
        return way.request().look().equals(least.look())
                && way.request().scene().mesh() == least.scene().mesh();
    }

    private String range(Plan plan) {
        if (plan.range().turn() == 0) return texts.text("range.here");
        return texts.text(
                "range",
                number(Math.toDegrees(plan.range().turn())),
                number(100 * (plan.range().zoom() - 1)));
    }

    private String number(double value) {
        if (Double.isInfinite(value)) return "∞";
        String three = String.format(texts.locale(), "%.3f", value);
        return three.replaceAll("0+$", "").replaceAll("[.,]$", "");
    }
}
