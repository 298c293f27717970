package rasterlab.app.light.panel;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.widget.Formula;
import rasterlab.app.language.Texts;
import rasterlab.app.light.LightFrame;
import rasterlab.app.light.LightLabState;
import rasterlab.app.light.OwnRemarks;
import rasterlab.app.light.PointReading;
import rasterlab.contract.Reflection;

/** The formula at the chosen point as the inspector writes it. */
final class LightReadings {
    private final LightLabState state;
    private final Texts texts;

    LightReadings(LightLabState state, Texts texts) {
        this.state = state;
        this.texts = texts;
    }

    private Optional<PointReading> reading() {
        return state.drawn().flatMap(LightFrame.DrawnFrame::point);
    }

    String place() {
        return reading()
                .map(
                        point ->
                                texts.text(
                                        "place.face",
                                        Integer.toString(point.face()),
                                        numbers(point.position(), 0)))
                .orElseGet(() -> texts.text("place.none"));
    }

    /** The formula, each lamp's numbers, and the sum. */
    List<Formula> formula() {
        var lines = new ArrayList<Formula>();
        Reflection reflection = state.choice().reflection();
        lines.add(words(texts.text("formula." + code(reflection))));
        if (reading().isEmpty()) return lines;
        PointReading point = reading().get();
        lines.add(words("n =", row(point.normal())));
        lines.add(words(texts.text("formula.own"), row(point.own())));
        for (PointReading.OfLamp lamp : point.lamps()) addLamp(lamp, reflection, lines);
        lines.add(words("I =", row(point.sum())));
        state.drawn()
                .flatMap(LightFrame.DrawnFrame::own)
                .flatMap(OwnRemarks::light)
                .ifPresent(mine -> lines.add(words(texts.text("formula.mine"), row(mine))));
        return lines;
    }

    private void addLamp(PointReading.OfLamp lamp, Reflection reflection, List<Formula> lines) {
        String number = Integer.toString(lamp.number());
        String cosines = "n·l = " + number(lamp.diffuse()) + ",";
        if (reflection == Reflection.PHONG) cosines += " r·v = " + number(lamp.mirrored()) + ",";
        if (reflection == Reflection.BLINN_PHONG)
            cosines += " n·h = " + number(lamp.mirrored()) + ",";
        lines.add(
                words(
                        texts.text("formula.lamp", number)
                                + " "
                                + cosines
                                + " f = "
                                + Shown.number(lamp.factor(), 3, texts.locale())));
        lines.add(words("      +", row(lamp.added())));
    }

    private static String code(Reflection reflection) {
        return switch (reflection) {
            case LAMBERT -> "lambert";
            case PHONG -> "phong";
            case BLINN_PHONG -> "blinn-phong";
        };
    }

    private Formula.Matrix row(double[] numbers) {
        return Formula.Matrix.row(Arrays.stream(numbers).mapToObj(this::number));
    }

    private static Formula words(String words) {
        return Formula.of(new Formula.FormulaWords(words));
    }

    private static Formula words(String words, Formula.Matrix matrix) {
        return Formula.of(new Formula.FormulaWords(words), matrix);
    }

    /** A cosine, a part of a direction or a share of full intensity. */
    private String number(double value) {
        return Shown.coordinate(value, 1, 3, texts.locale());
    }

    private String numbers(double[] values, int decimals) {
        return Shown.number(Math.rint(values[0]), decimals, texts.locale())
                + Shown.apart(texts.locale())
                + Shown.number(Math.rint(values[1]), decimals, texts.locale())
                + Shown.apart(texts.locale())
                + Shown.number(Math.rint(values[2]), decimals, texts.locale());
    }
}
