package rasterlab.engine.signmap;

import java.util.List;
import rasterlab.engine.naming.Named;
import rasterlab.engine.predicate.PointQuestion;

/**
 * The sign maps of a predicate's forms, around the point (½, ½).
 *
 * @param exact the right sign, whatever it costs
 */
record FormSigns(String name, List<SignForm> forms, Sign exact) implements SignSubject {
    private static final int SIZE = 128;

    @Override
    public List<String> methods() {
        return forms.stream().map(SignForm::name).toList();
    }

    @Override
    public SignMap map(String method) {
        SignForm form = Named.find(name + " method", method, forms, SignForm::name);
        var field = new SignField(form.spacing(), SIZE, PointQuestion.HALF, PointQuestion.HALF);
        return new SignMap(
                name, method, false, field, field.answers(form.sign()), field.answers(exact));
    }
}
