package rasterlab.app.cli.render;

import java.util.Optional;
import picocli.CommandLine.ITypeConverter;
import rasterlab.app.cli.console.OptionNumbers;

/**
 * Reads how near or far is drawn, in world units; or none, which takes a scene file's word back.
 */
final class DepthOption implements ITypeConverter<DepthOption.Limit> {
    /**
     * @param units empty where nothing is cut off
     */
    record Limit(Optional<Double> units) {}

    @Override
    public Limit convert(String text) {
        if (text.equals(LookOptions.NONE)) return new Limit(Optional.empty());
        return new Limit(Optional.of(OptionNumbers.number(text)));
    }
}
