package rasterlab.exercises.formula;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/** Formulas set in type; the last ones are remembered. For any thread. */
public final class Formulas {
    private static final int MOST = 1000;

    private final Map<TexFormula, Typeset> remembered =
            Collections.synchronizedMap(
                    new LinkedHashMap<>(16, 0.75f, true) {
                        private static final long serialVersionUID = 1L;

                        @Override
                        protected boolean removeEldestEntry(Map.Entry<TexFormula, Typeset> eldest) {
                            return size() > MOST;
                        }
                    });

    /** Sets the formula, which takes some tenths of a second the first time. */
    public Typeset set(TexFormula formula) {
        Typeset known = remembered.get(formula);
        if (known != null) return known;
        Typeset made = Typesetter.set(formula);
        remembered.put(formula, made);
        return made;
    }

    /** The formula if it was set before; takes no time. */
    public Optional<Typeset> known(TexFormula formula) {
        return Optional.ofNullable(remembered.get(formula));
    }
}
