package rasterlab.app.cli.render;

import picocli.CommandLine.ITypeConverter;
import rasterlab.app.cli.console.OptionNumbers;
import rasterlab.app.outcome.Complaint;
import rasterlab.engine.plan.Tolerance;

/** Reads the numbers of a tolerance; whoever types another word is told which are allowed. */
final class ToleranceOption {
    private ToleranceOption() {}

    /**
     * The tolerance of options; a complaint names the option.
     *
     * @throws Complaint for a number that is not allowed
     */
    static Tolerance of(double pixels, double levels, double share) {
        try {
            return new Tolerance(pixels, levels, share);
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput("--" + e.getMessage());
        }
    }

    /** Reads how far things may be out of place, in pixels. */
    static final class PixelsReader implements ITypeConverter<Double> {
        @Override
        public Double convert(String text) {
            return OptionNumbers.number(text, "above 0 and at most 64");
        }
    }

    /** Reads how far a channel may be off, in levels. */
    static final class LevelsReader implements ITypeConverter<Double> {
        @Override
        public Double convert(String text) {
            return OptionNumbers.number(text, "from 0 to 255");
        }
    }

    /** Reads a share of the pixels. */
    static final class ShareReader implements ITypeConverter<Double> {
        @Override
        public Double convert(String text) {
            return OptionNumbers.number(text, "from 0 to 1");
        }
    }
}
