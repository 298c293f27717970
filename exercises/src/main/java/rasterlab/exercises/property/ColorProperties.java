package rasterlab.exercises.property;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rasterlab.contract.ColorModel;
import rasterlab.engine.color.ColorSheet;
import rasterlab.engine.color.Colors;
import rasterlab.exercises.property.Relation.AnsweredInput;
import rasterlab.exercises.property.Relation.Broken;
import rasterlab.exercises.property.Relation.Equivalence;

/** Properties of colours in several models: they mean the same in each. */
final class ColorProperties {
    /** The models in which every combination of numbers in their ranges is a colour. */
    private static final List<ColorModel> MODELS =
            List.of(ColorModel.RGB, ColorModel.CMY, ColorModel.CMYK, ColorModel.HSV);

    static final List<Property<Colors, ColorSheet>> ALL =
            List.of(Property.always("color", "round-trip", new RoundTrip()));

    private ColorProperties() {}

    /** The relation that a colour as written in another model is in all models the first one. */
    private static final class RoundTrip implements Relation<Colors, ColorSheet> {
        @Override
        public List<Colors> furtherInputs(Colors colors, ColorSheet sheet) {
            List<Colors> written = new ArrayList<>();
            for (ColorModel model : MODELS)
                if (model != colors.model())
                    written.add(new Colors(model, inRange(model, sheet.in(model))));
            return written;
        }

        /** Rounding may have brought a number out of it, which a method may refuse. */
        private static double[] inRange(ColorModel model, double[] components) {
            double[] near = components.clone();
            for (int i = 0; i < near.length; i++)
                near[i] = Math.max(0, Math.min(model.highest(i % model.size()), near[i]));
            return near;
        }

        @Override
        public Optional<Broken<Colors, ColorSheet>> broken(
                AnsweredInput<Colors, ColorSheet> first,
                List<AnsweredInput<Colors, ColorSheet>> written,
                Equivalence<Colors, ColorSheet> alike) {
            for (AnsweredInput<Colors, ColorSheet> one : written)
                if (!alike.test(one.input(), first.output(), one.output()))
                    return Optional.of(new Broken<>(one, first.output()));
            return Optional.empty();
        }
    }
}
