package rasterlab.app.shell.labs;

import java.util.LinkedHashMap;
import java.util.Map;
import rasterlab.exercises.Exercise;

/**
 * Remembers over which labs it is said for which exercise their input can be handed in, for a
 * window in another language or theme.
 */
public final class HandInOffers {
    /**
     * An offer that is made over a lab.
     *
     * @param refused whether the lab showed no input of the topic when one was to be handed in
     */
    public record Offer(Exercise exercise, boolean refused) {}

    private final Map<String, Offer> offers = new LinkedHashMap<>();

    /** Takes what is said over the lab of that tab, in place of what was said there before. */
    public void show(String tab, Offer offer) {
        offers.put(tab, offer);
    }

    /** Notes that nothing is said over the lab of that tab any more. */
    public void hide(String tab) {
        offers.remove(tab);
    }

    /** Gives what is said now, by the names of the tabs. */
    public Map<String, Offer> shown() {
        return Map.copyOf(offers);
    }
}
