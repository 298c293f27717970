package rasterlab.engine.signmap;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rasterlab.engine.naming.Named;
import rasterlab.engine.predicate.PointQuestion;
import rasterlab.engine.predicate.Spacing;

/** The sign maps of a predicate's forms, around the point (½, ½). */
final class FormSigns implements SignSubject {
    private static final int SIZE = 128;

    private final String name;
    private final String others;
    private final List<SignForm> forms;
    private final Sign exact;
    private final Map<Spacing, byte[]> right = new EnumMap<>(Spacing.class);

    /**
     * @param others the points that stay where they are
     * @param exact the right sign, whatever it costs
     */
    FormSigns(String name, String others, List<SignForm> forms, Sign exact) {
        this.name = name;
        this.others = others;
        this.forms = List.copyOf(forms);
        this.exact = exact;
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public Optional<String> others() {
        return Optional.of(others);
    }

    @Override
    public List<String> methods() {
        return forms.stream().map(SignForm::name).toList();
    }

    @Override
    public SignMap map(String method) {
        SignForm form = Named.find(name + " method", method, forms, SignForm::name);
        var field = new SignField(form.spacing(), SIZE, PointQuestion.HALF, PointQuestion.HALF);
        return new SignMap(name, method, false, field, field.answers(form.sign()), right(field));
    }

    private synchronized byte[] right(SignField field) {
        return right.computeIfAbsent(field.spacing(), spacing -> field.answers(exact));
    }
}
