package rasterlab.app.canvas.lab;

/**
 * A hazard as it is told over a stage, for the same lab made again in another language.
 *
 * @param hazard in the language before, with the verdicts that were found
 * @param input the lab's, with which the hazard's verdicts go
 * @param before name of the method that was chosen when the hazard was clicked
 * @param judging whether its verdicts were still being found
 */
public record ShownHazard(HazardCase hazard, Object input, String before, boolean judging) {
    /** The verdicts that were found beside the words of another language. */
    HazardCase in(HazardCase words) {
        return new HazardCase(
                words.name(),
                words.label(),
                words.special(),
                hazard.methods(),
                hazard.recorded(),
                words.show());
    }
}
