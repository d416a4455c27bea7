//! Measures of agreement on synthetic spectra whose answer is known by construction.

use bevelscope::agreement::{
    Agreement, AgreementError, Tolerance, agreement_limit, frac, pair_peaks, peaks, sixth_octave_bands,
};
use num_complex::Complex64;

use crate::support::assert_close;

const TOLERANCE: Tolerance = Tolerance { band_level_db: 3.0 };

/// Equally spaced lines, both ends included.
fn lines(low: f64, high: f64, count: usize) -> Vec<f64> {
    (0..count).map(|i| low + (high - low) * i as f64 / (count - 1) as f64).collect()
}

/// Single-degree resonators of unit static response side by side, loss factor 0.01.
fn resonances(lines: &[f64], at: &[f64]) -> Vec<Complex64> {
    let response = |f: f64| at.iter().map(|r| 1.0 / Complex64::new(1.0 - (f / r).powi(2), 0.01)).sum::<Complex64>();
    lines.iter().map(|f| 100.0 * response(*f)).collect()
}

fn compare(lines: &[f64], lumped: &[Complex64], fe: &[Complex64]) -> Agreement {
    Agreement::new(lines, lumped, fe, None, Tolerance::default()).unwrap()
}

/// Edge below band k, ISO-like base-two sixth octaves around 1 kHz, in its own words: a twelfth of an octave below the centre.
fn edge(k: i32) -> f64 {
    1000.0 * 2.0_f64.powf(f64::from(k) / 6.0) * 2.0_f64.powf(-1.0 / 12.0)
}

#[test]
fn a_spectrum_agrees_with_itself() {
    let lines = lines(10.0, 4000.0, 1000);
    let force = resonances(&lines, &[300.0, 900.0, 2500.0]);
    let agreement = compare(&lines, &force, &force);
    assert_eq!((agreement.rms_db, agreement.max_db, agreement.agreement_limit_hz), (0.0, 0.0, 4000.0));
    assert!((agreement.frac - 1.0).abs() < 1e-15);
    assert_eq!(agreement.peaks.len(), 3);
    for peak in agreement.peaks {
        assert_eq!((peak.shift_percent, peak.height_db), (Some(0.0), Some(0.0)));
    }
}

#[test]
fn scaling_is_a_difference_in_db_and_nothing_else() {
    let lines = lines(10.0, 4000.0, 1000);
    let force = resonances(&lines, &[300.0, 900.0, 2500.0]);
    // 1.41 is 2.98 dB and 1.42 is 3.05 dB; a phase is no difference of level, and 1e60 overflows a careless square of a square
    for (factor, limit) in [
        (Complex64::new(1.41, 0.0), 4000.0),
        (Complex64::new(1.0 / 1.41, 0.0), 4000.0),
        (Complex64::new(1.42, 0.0), 0.0),
        (Complex64::new(0.0, -1.0), 4000.0),
        (Complex64::from_polar(1e60, 2.0), 0.0),
    ] {
        let scaled: Vec<Complex64> = force.iter().map(|f| f * factor).collect();
        let agreement = compare(&lines, &scaled, &force);
        let db = 20.0 * factor.norm().log10();
        assert!((agreement.rms_db - db.abs()).abs() < 1e-12 * (1.0 + db.abs()), "{} {db}", agreement.rms_db);
        assert!((agreement.max_db - db.abs()).abs() < 1e-12 * (1.0 + db.abs()), "{} {db}", agreement.max_db);
        assert!((agreement.frac - 1.0).abs() < 1e-14, "{}", agreement.frac);
        assert_eq!(agreement.agreement_limit_hz, limit, "{factor}");
        for peak in &agreement.peaks {
            assert!((peak.height_db.unwrap() - db).abs() < 1e-9);
        }
    }
}

#[test]
fn frac_sees_phase_and_shape() {
    let one = [Complex64::new(1.0, 0.0), Complex64::new(0.0, 1.0)];
    let orthogonal = [Complex64::new(1.0, 0.0), Complex64::new(0.0, -1.0)];
    assert!(frac(&one, &orthogonal).abs() < 1e-15);
    // (3 + 8)^2 / (5 * 25)
    let (a, b) = ([1.0, 2.0].map(Complex64::from), [3.0, 4.0].map(Complex64::from));
    assert_close("FRAC", frac(&a, &b), 121.0 / 125.0, 1e-15);
}

#[test]
fn rms_largest_difference_and_band() {
    let lines = [100.0, 200.0, 300.0, 400.0];
    let fe = [1.0; 4].map(Complex64::from);
    // 0, 20, -40, 6 dB
    let lumped = [1.0, 10.0, 0.01, 10.0_f64.powf(0.3)].map(Complex64::from);
    let agreement = compare(&lines, &lumped, &fe);
    assert_close("RMS", agreement.rms_db, ((400.0 + 1600.0 + 36.0) / 4.0_f64).sqrt(), 1e-14);
    assert_eq!(agreement.max_at_hz, 300.0);
    assert_close("largest", agreement.max_db, 40.0, 1e-14);
    // both ends of a band are in it
    let band = |band| Agreement::new(&lines, &lumped, &fe, Some(band), TOLERANCE);
    assert_close("RMS", band([100.0, 200.0]).unwrap().rms_db, 200.0_f64.sqrt(), 1e-14);
    assert_eq!(band([401.0, 500.0]).unwrap_err(), AgreementError::EmptyBand { low: 401.0, high: 500.0 });
    assert_eq!(band([300.0, 200.0]).unwrap_err(), AgreementError::EmptyBand { low: 300.0, high: 200.0 });
    // but the agreement limit is over all lines
    assert_eq!(band([200.0, 200.0]).unwrap().agreement_limit_hz, agreement.agreement_limit_hz);
}

/// Level differences put in band by band: the limit is the upper edge of the last good one below the first bad one.
#[test]
fn limit_of_synthetic_bands() {
    let lines = lines(100.0, 3000.0, 2901);
    let fe = resonances(&lines, &[300.0, 900.0, 2500.0]);
    let band_of = |f: f64| (-30..20).rev().find(|k| f >= edge(*k) * (1.0 - 1e-12)).unwrap();
    let limit = |difference: &dyn Fn(i32) -> f64| {
        let factor = |f: f64| 10.0_f64.powf(difference(band_of(f)) / 20.0);
        let lumped: Vec<Complex64> = lines.iter().zip(&fe).map(|(f, force)| force * factor(*f)).collect();
        agreement_limit(&lines, &lumped, &fe, TOLERANCE)
    };
    assert_eq!(limit(&|_| 2.99), 3000.0);
    assert_eq!(limit(&|_| -2.99), 3000.0);
    assert_eq!(limit(&|_| 3.01), 0.0);
    for bad in [-15, -3, 0, 4, 9] {
        for db in [3.01, -3.01] {
            let found = limit(&|k| if k == bad { db } else { 2.9 });
            assert_close("limit", found, edge(bad), 1e-12);
        }
    }
    // bands below the lines, and above, are nobody's
    assert_eq!(limit(&|k| if k < band_of(100.0) || k > band_of(3000.0) { 9.0 } else { 0.0 }), 3000.0);
    // a wider tolerance is the user's choice
    let scaled: Vec<Complex64> = fe.iter().map(|force| force * 2.0).collect();
    assert_eq!(agreement_limit(&lines, &scaled, &fe, Tolerance { band_level_db: 6.1 }), 3000.0);
}

/// A deep antiresonance that moves is no reason to distrust a model: levels are energies over a band.
#[test]
fn an_antiresonance_does_not_stop_the_limit() {
    let lines = lines(900.0, 1100.0, 201);
    let dip = |at: f64| {
        lines.iter().map(|f| Complex64::new(((f - at) / 50.0).abs().min(1.0) + 1e-4, 0.0)).collect::<Vec<_>>()
    };
    let agreement = compare(&lines, &dip(1000.0), &dip(1005.0));
    assert!(agreement.max_db > 40.0);
    assert_eq!(agreement.agreement_limit_hz, 1100.0);
}

/// The lower edge belongs to a band, the upper one to the next; bands without a line are skipped.
#[test]
fn lines_on_band_edges() {
    let edges: Vec<f64> = (-40..16).map(|k| 1000.0 * (f64::from(2 * k - 1) / 12.0).exp2()).collect();
    for (found, k) in edges.iter().zip(-40..) {
        assert_close("edge", *found, edge(k), 1e-13);
    }
    let bands = sixth_octave_bands(&edges);
    assert_eq!(bands.len(), edges.len());
    for (i, band) in bands.iter().enumerate() {
        assert_eq!((band.low_hz, band.lines.clone()), (edges[i], i..i + 1));
        assert!(i + 1 == edges.len() || band.high_hz == edges[i + 1]);
    }
    // one rounding below its edge a line is in the band below
    let below: Vec<f64> = edges.iter().map(|f| f.next_down()).collect();
    for (i, band) in sixth_octave_bands(&below).iter().enumerate().skip(1) {
        assert_eq!(band.high_hz, edges[i]);
    }
    // 1 kHz is a centre; nothing between 200 and 1000 Hz
    let sparse = sixth_octave_bands(&[199.0, 200.0, 1000.0, 1050.0, 4000.0]);
    assert_eq!(sparse.iter().map(|band| band.lines.clone()).collect::<Vec<_>>(), [0..2, 2..4, 4..5]);
    assert_close("edge", sparse[1].low_hz, 943.874_312_681_693_5, 1e-14);
    assert!(sixth_octave_bands(&[]).is_empty());
}

/// Every line is in exactly one band, whatever the lines.
#[test]
fn bands_partition_the_lines() {
    let ranges: [(f64, f64, i32); 4] = [(1e-6, 1e-3, 997), (0.01, 20.0, 1999), (10.0, 4000.0, 1000), (1.0, 1e9, 5003)];
    for (low, high, count) in ranges {
        let lines: Vec<f64> =
            (0..count).map(|i| low * (high / low).powf(f64::from(i) / f64::from(count - 1))).collect();
        let mut next = 0;
        for band in sixth_octave_bands(&lines) {
            assert_eq!(band.lines.start, next);
            assert!(!band.lines.is_empty());
            for line in &lines[band.lines.clone()] {
                assert!((band.low_hz..band.high_hz).contains(line), "{line} in {band:?}");
            }
            next = band.lines.end;
        }
        assert_eq!(next, lines.len());
    }
}

#[test]
fn peaks_of_known_resonances() {
    let lines = lines(10.0, 4000.0, 3991);
    let at = [150.0, 700.0, 1900.0, 3300.0];
    let force = resonances(&lines, &at);
    let found = peaks(&lines, &force);
    assert_eq!(found.iter().map(|peak| peak.frequency_hz).collect::<Vec<_>>(), at);
    for peak in &found {
        // 100 / 0.01 and a little from the neighbours
        assert!((peak.level_db - 80.0).abs() < 0.5, "{peak:?}");
    }
    // all resonances 4 % higher, and one more
    let moved = resonances(&lines, &[156.0, 728.0, 1300.0, 1976.0, 3432.0]);
    let pairs = pair_peaks(&peaks(&lines, &moved), &found);
    let expected = [
        (Some(150.0), Some(156.0)),
        (Some(700.0), Some(728.0)),
        (None, Some(1300.0)),
        (Some(1900.0), Some(1976.0)),
        (Some(3300.0), Some(3432.0)),
    ];
    assert_eq!(pairs.iter().map(|pair| (pair.fe_hz, pair.lumped_hz)).collect::<Vec<_>>(), expected);
    for pair in pairs.iter().filter(|pair| pair.fe_hz.is_some()) {
        assert_close("shift", pair.shift_percent.unwrap(), 4.0, 1e-12);
        assert!(pair.height_db.unwrap().abs() < 0.5);
    }
    assert_eq!((pairs[2].shift_percent, pairs[2].height_db), (None, None));
}

/// Levels in dB to forces.
fn levels(db: &[f64]) -> (Vec<f64>, Vec<Complex64>) {
    let lines = (1..=db.len()).map(|i| 100.0 * i as f64).collect();
    (lines, db.iter().map(|db| Complex64::from_polar(10.0_f64.powf(db / 20.0), 1.0)).collect())
}

fn peaks_at(db: &[f64]) -> Vec<f64> {
    let (lines, force) = levels(db);
    peaks(&lines, &force).iter().map(|peak| peak.frequency_hz).collect()
}

#[test]
fn what_counts_as_a_peak() {
    // the ends do not, whatever their height
    assert!(peaks_at(&[50.0, 10.0, 5.0, 10.0, 50.0]).is_empty());
    assert!(peaks_at(&[10.0]).is_empty() && peaks_at(&[]).is_empty() && peaks_at(&[1.0, 9.0]).is_empty());
    // prominence: from the higher of the two valleys before something higher
    assert_eq!(peaks_at(&[0.0, 20.0, 17.1, 19.9, 0.0]), [200.0]);
    assert_eq!(peaks_at(&[0.0, 20.0, 16.8, 19.9, 0.0]), [200.0, 400.0]);
    assert_eq!(peaks_at(&[18.0, 20.0, 0.0]), Vec::<f64>::new());
    assert_eq!(peaks_at(&[16.9, 20.0, 0.0]), [200.0]);
    // a shoulder of a higher peak: up 4 dB from its valley, but the valley before the higher one is 2 dB down
    assert_eq!(peaks_at(&[0.0, 10.0, 8.0, 20.0, 6.0, 0.0]), [400.0]);
    // of a plateau the first line; a plateau that goes on rising is none, nor one that reaches the end
    let (lines, mut force) = levels(&[0.0, 10.0, 10.0, 0.0, 10.0, 10.0, 20.0, 5.0, 12.0, 12.0]);
    for (to, from) in [(2, 1), (5, 4), (9, 8)] {
        force[to] = force[from];
    }
    let found: Vec<f64> = peaks(&lines, &force).iter().map(|peak| peak.frequency_hz).collect();
    assert_eq!(found, [200.0, 700.0]);
}

/// The closest pair first, each peak once, none farther than 15 %.
#[test]
fn pairing_is_one_to_one_and_greedy() {
    let peak = |frequency_hz| bevelscope::agreement::Peak { frequency_hz, level_db: 0.0 };
    let pairs = |lumped: &[f64], fe: &[f64]| {
        let of = |at: &[f64]| at.iter().map(|f| peak(*f)).collect::<Vec<_>>();
        pair_peaks(&of(lumped), &of(fe)).iter().map(|pair| (pair.fe_hz, pair.lumped_hz)).collect::<Vec<_>>()
    };
    // 1040 is nearer to 1050 than to 1000; what is left of 1000 takes 900
    assert_eq!(pairs(&[900.0, 1040.0], &[1000.0, 1050.0]), [(Some(1000.0), Some(900.0)), (Some(1050.0), Some(1040.0))]);
    assert_eq!(pairs(&[1150.0], &[1000.0]), [(Some(1000.0), Some(1150.0))]);
    assert_eq!(pairs(&[1150.1], &[1000.0]), [(Some(1000.0), None), (None, Some(1150.1))]);
    assert_eq!(pairs(&[990.0, 1020.0], &[1000.0]), [(Some(1000.0), Some(990.0)), (None, Some(1020.0))]);
    assert_eq!(pairs(&[], &[5.0]), [(Some(5.0), None)]);
}
