package rasterlab.app.coordinates.meeting;

import java.util.ArrayList;
import java.util.List;
import rasterlab.app.canvas.Shown;
import rasterlab.app.language.Texts;
import rasterlab.engine.geometry.Plane;
import rasterlab.engine.geometry.Vector;

/** The live numbers as inspector and stage write them. */
final class MeetingReadings {
    private static final int DIGITS = 4;

    private final MeetingLabModel model;
    private final Texts texts;

    MeetingReadings(MeetingLabModel model, Texts texts) {
        this.model = model;
        this.texts = texts;
    }

    private String number(double value) {
        return Shown.number(value, DIGITS, texts.locale());
    }

    String vector(Vector v) {
        String apart = Shown.apart(texts.locale());
        return "(" + number(v.x()) + apart + number(v.y()) + apart + number(v.z()) + ")";
    }

    String normal() {
        return vector(model.choice().plane().normal());
    }

    String constant() {
        return number(model.choice().plane().c());
    }

    String from() {
        return vector(model.choice().line().from());
    }

    String through() {
        return vector(model.choice().line().through());
    }

    /** Distances of p₁ and p₂ from the plane, positive on the normal's side. */
    String heights() {
        Plane plane = model.choice().plane();
        return number(SideView.height(plane, model.choice().line().from()))
                + Shown.apart(texts.locale())
                + number(SideView.height(plane, model.choice().line().through()));
    }

    String distance() {
        return number(model.choice().plane().distanceFromOrigin());
    }

    String angle() {
        return number(model.choice().plane().angleWith(model.choice().line())) + "°";
    }

    String cosines() {
        return vector(model.choice().line().direction().unit());
    }

    List<String> headings() {
        return List.of(texts.text("answer.method"), "μ", texts.text("answer.verdict"));
    }

    /** The methods' answers, and the right one below them. */
    List<List<String>> rows() {
        var rows = new ArrayList<List<String>>();
        for (MeetingScene.MeetingAnswer each : model.scene().answers())
            rows.add(List.of(each.method(), mu(each), verdict(each)));
        double exact = model.scene().exact();
        rows.add(List.of(texts.text("exact"), Double.isNaN(exact) ? "—" : longer(exact), ""));
        return rows;
    }

    private String mu(MeetingScene.MeetingAnswer answer) {
        return answer.refused() ? "—" : longer(answer.mu());
    }

    private String longer(double mu) {
        if (Double.isInfinite(mu)) return mu > 0 ? "∞" : "−∞";
        if (Double.isNaN(mu)) return texts.text("nan");
        return Shown.number(mu, 2 * DIGITS, texts.locale());
    }

    private String verdict(MeetingScene.MeetingAnswer answer) {
        if (answer.refused())
            return texts.text(answer.right() ? "verdict.refused" : "verdict.fails");
        return texts.text(answer.right() ? "verdict.right" : "verdict.wrong");
    }

    int chosenRow() {
        return model.scene().answers().indexOf(model.scene().chosen());
    }

    /** Says what is out of sight; "" where all is in sight. */
    String note() {
        double exact = model.scene().exact();
        if (!model.view().reached()) return texts.text("note.plane");
        if (Double.isNaN(exact)) return texts.text("note.none");
        return MeetingFigure.drawn(exact) ? "" : texts.text("note.far", number(exact));
    }
}
