package rasterlab.app.plan.least;

import java.util.List;
import java.util.stream.Collectors;
import rasterlab.app.canvas.Shown;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.plan.PlanReport;
import rasterlab.engine.plan.Plan;
import rasterlab.engine.plan.PlanDecision;
import rasterlab.engine.plan.PlanTrial;

/** The bill of a least picture in words and numbers of one language. */
public final class PlanReadings {
    private final Texts texts;

    public PlanReadings(Language language) {
        texts = Texts.of("plan", language);
    }

    String predictedError(Plan plan) {
        return texts.text(
                "least.error.value",
                number(plan.predictedPixels()),
                number(plan.predictedLevels()));
    }

    String predictedTime(Plan plan) {
        return time(plan.cost().milliseconds(), plan.fullCost().milliseconds());
    }

    String measuredError(PlanTrial trial) {
        return texts.text(
                "least.measured.value", Math.round(trial.error().levels()), trial.error().wrong());
    }

    /** Processor time of the whole picture: the wall clock depends on who else works. */
    String measuredTime(PlanTrial trial) {
        return time(trial.processor(), trial.fullProcessor());
    }

    private String time(double least, double full) {
        return texts.text(
                "least.time.value",
                number(least),
                number(full),
                Long.toString(Math.round(100 * least / full)));
    }

    /** The number of pictures that the plan has drawn, and the cameras that it holds for. */
    String kept(PlannedPicture picture) {
        Plan plan = picture.plan();
        return texts.text(
                plan.range().turn() == 0 ? "least.kept.here" : "least.kept.value",
                picture.pictures(),
                number(Math.toDegrees(plan.range().turn())),
                number(100 * (plan.range().zoom() - 1)));
    }

    /** The decisions, each with its reason, a paragraph each. */
    String decisions(Plan plan) {
        List<PlanDecision> decisions = plan.decisions();
        if (decisions.isEmpty()) return texts.text("least.whole");
        return decisions.stream().map(this::decision).collect(Collectors.joining("\n"));
    }

    private String decision(PlanDecision decision) {
        boolean terms = decision.saves() && decision.subject().equals("terms");
        String said =
                texts.text(
                        terms ? "decision.terms" : decision.saves() ? "decision" : "kept",
                        texts.text("subject." + decision.subject()),
                        PlanReport.word(texts, decision.chosen()),
                        PlanReport.word(texts, decision.instead()));
        return texts.text("least.decision", said.strip(), PlanReport.reason(texts, decision));
    }

    /** A sentence about the picture of a difference. */
    public String difference(MagnifiedDifference difference) {
        return difference.largest() == 0
                ? texts.text("least.alike")
                : texts.text("least.difference", difference.factor(), difference.largest());
    }

    private String number(double value) {
        return Shown.number(value, 2, texts.locale());
    }
}
