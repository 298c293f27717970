package rasterlab.engine.scene.obj;

import java.util.Arrays;

/**
 * Numbers different triples in the order they first come.
 *
 * <p>A hash table with open addressing, at most half full, so a search looks at about two slots
 * whatever the number of triples.
 */
final class CornerTable {
    private static final int EMPTY = -1;

    private final Ints triples = new Ints();
    private int[] slots = new int[64];

    CornerTable() {
        Arrays.fill(slots, EMPTY);
    }

    int size() {
        return triples.size() / 3;
    }

    /** Item 0, 1 or 2 of a triple. */
    int get(int triple, int item) {
        return triples.get(3 * triple + item);
    }

    /** The number of the triple, which is added where it is new. */
    int number(int a, int b, int c) {
        int slot = slot(a, b, c);
        if (slots[slot] != EMPTY) return slots[slot];
        int number = size();
        slots[slot] = number;
        triples.add(a);
        triples.add(b);
        triples.add(c);
        if (2 * size() > slots.length) grow();
        return number;
    }

    private int slot(int a, int b, int c) {
        int slot = hash(a, b, c) & slots.length - 1;
        while (slots[slot] != EMPTY && !isAt(slots[slot], a, b, c))
            slot = slot + 1 & slots.length - 1;
        return slot;
    }

    private boolean isAt(int number, int a, int b, int c) {
        return get(number, 0) == a && get(number, 1) == b && get(number, 2) == c;
    }

    /** Odd factors spread the low bits; the shift brings the high ones down. */
    private static int hash(int a, int b, int c) {
        int mixed = ((a * 0x9E3779B1) ^ b) * 0x85EBCA6B ^ c;
        mixed *= 0xC2B2AE35;
        return mixed ^ mixed >>> 15;
    }

    private void grow() {
        slots = new int[2 * slots.length];
        Arrays.fill(slots, EMPTY);
        for (int number = 0; number < size(); number++)
            slots[slot(get(number, 0), get(number, 1), get(number, 2))] = number;
    }
}
