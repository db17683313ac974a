//! Compact corner sets of few colors on tori that no other construction gives.
//!
//! Found by annealing, with the symmetry of [`crate::anneal::compact`] where a side is a
//! multiple of the colors, without any for the two tori that are two rows high. On these every
//! window is met again from below, turned around: (NW, SW, SE) and (SE, NE, NW) come together.
//! They are the beginning of many other tori ([`super::copies`]). Source: this project.

/// Colors, and the rows of the torus.
pub const KNOWN: [(usize, &[&str]); 7] = [
    // The compact set over two colors is the complete one.
    (2, &["0001", "0010", "1011", "0111"]),
    (3, &["211022100", "110221002", "020101212", "202010121", "200011122", "111222000"]),
    (3, &["201221012002120110", "202110010221121002", "000201111012222120"]),
    (3, &["010020120220002112100121102", "111100222210100220122011212"]),
    (
        4,
        &[
            "33230011003011221101223322123300",
            "20002013311131200222023113331302",
            "21010213321213200323203110303102",
            "01001302121120132322312030330231",
        ],
    ),
    (
        4,
        &[
            "2201331220302112103131330320213132311101333123002123202023112023",
            "0111211130100331223303301013010022221000003233223010220032032121",
        ],
    ),
    (
        5,
        &[
            "33024033101313423112331031432341222123014034131010132334341434\
             10133004332312113022120300224332144323002403020414402434044413\
             0",
            "41420111042200220413343244442124434111122014432142104030002041\
             03240221133031142224232311212013104244200140010002423321203404\
             0",
        ],
    ),
];
